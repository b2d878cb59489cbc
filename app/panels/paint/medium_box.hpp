// The media to choose from: by family, each with a swatch of what it is like and its sentence.
#pragma once

#include <vector>

#include <QComboBox>
#include <QImage>

namespace pastoso::panels {

/// Of the swatches, in pixels of the layout.
inline constexpr QSize kMediumSwatch(80, 50);

class MediumBox : public QComboBox {
    Q_OBJECT
  public:
    explicit MediumBox(QWidget* parent = nullptr);

    /// Without a signal.
    void show_medium(const QString& name);
    /// By the names that they are kept under.
    QStringList media() const;
    QString shown_medium(const QString& name) const;
    QString sentence(const QString& name) const;  ///< what the medium is like

    /// As a click on it in the list does.
    void choose(const QString& name);

    QImage swatch(const QString& name) const;
    void set_swatch(const QString& name, const QImage& image);

    void showPopup() override;

  protected:
    /// The tip begins with the whole name.
    bool event(QEvent* event) override;
    /// Its name as far as there is room for it.
    void paintEvent(QPaintEvent* event) override;

  Q_SIGNALS:
    void medium_chosen(const QString& name);
    void swatches_wanted();  ///< the list is opened

  private:
    void add_heading(const QString& family);
};

}  // namespace pastoso::panels
