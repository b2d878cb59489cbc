// The tubes of paint.
#pragma once

#include "tools/drawdown.hpp"

#include <vector>

#include <QColor>
#include <QIcon>
#include <QString>
#include <QWidget>

class QListWidgetItem;

namespace pastoso::panels {

class ChoiceList;

struct PaintEntry {
    QString pigment;  ///< Colour Index name, empty for the medium alone
    QString name;
};

class PaintPanel : public QWidget {
    Q_OBJECT
  public:
    explicit PaintPanel(const std::vector<PaintEntry>& paints, QWidget* parent = nullptr);

    /// Shows all paint as it looks there from now on.
    void show_swatches(const tools::SwatchView& view);

    /// Shows what the brush is dipped in, without a signal; nothing when it is from no tube.
    void show_paint(const QString& pigment);

    const std::vector<PaintEntry>& paints() const { return paints_; }

    /// As a click on it does.
    void choose(const QString& pigment) { Q_EMIT paint_chosen(pigment); }

  Q_SIGNALS:
    /// Also when the same paint is chosen again, which means a fresh dip.
    void paint_chosen(const QString& pigment);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    /// The colours of a tube's icon.
    struct Colours {
        QColor ink, chosen_ink;  ///< of the mark
        pigment::Srgb8 paint{}, tint{};
        tools::Drawdown drawdown;
        friend bool operator==(const Colours&, const Colours&) = default;
    };
    static QString words_of(const QListWidgetItem& item, const Colours& colours, double film_mm);
    void draw_icons();
    static QIcon icon_of(const Colours& colours, double pixel_ratio);

    std::vector<PaintEntry> paints_;
    tools::SwatchView view_;
    ChoiceList* list_ = nullptr;
    std::vector<Colours> shown_;  ///< of each row
};

}  // namespace pastoso::panels
