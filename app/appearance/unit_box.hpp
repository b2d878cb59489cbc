// Boxes for lengths and resolutions as painters know them: in millimetres, centimetres, metres, inches,
// or dpi.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <QDoubleSpinBox>
#include <QLocale>

namespace pastoso::appearance {

/// A box for a number in one unit, into which another may be typed. What it cannot read it says, and the
/// number stays what it was before that was typed.
class UnitBox : public QDoubleSpinBox {
    Q_OBJECT
  public:
    /// In `words` without spaces at its ends and in small letters; nothing where it is no such number.
    using Reader = std::optional<double> (*)(const QString& words, const QLocale& locale);

    /// Numbers have two decimals.
    UnitBox(Reader reader, const QString& name, const QString& suffix, QWidget* parent = nullptr);

    /// Of a length in mm: pixels may be typed as well, of that resolution.
    void read_pixels_at(std::function<double()> px_per_mm) { px_per_mm_ = std::move(px_per_mm); }

    QValidator::State validate(QString& text, int& cursor) const override;
    void fixup(QString& text) const override;
    double valueFromText(const QString& text) const override;
    void stepBy(int steps) override;

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QString typed_in(const QString& text) const;
    std::optional<double> read(const QString& text) const;
    bool begins_as_number(const QString& text) const;
    void tell_refused(const QString& text) const;

    Reader reader_;
    std::function<double()> px_per_mm_{};  ///< none: pixels are not read
    std::optional<double> before_typing_;
};

/// "500", "50 cm", "0.5 m", "20 in" or 20"; a number alone is of millimetres.
std::optional<double> read_length_mm(const QString& words, const QLocale& locale);

/// "5", "5 px/mm" or "127 dpi" (ppi); a number alone is of pixels per millimetre.
std::optional<double> read_px_per_mm(const QString& words, const QLocale& locale);

}  // namespace pastoso::appearance
