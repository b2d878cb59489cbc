// The tubes of paint.
#pragma once

#include "tools/swatch.hpp"

#include <vector>

#include <QIcon>
#include <QString>
#include <QWidget>

class QListWidget;

namespace pastoso::panels {

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

  Q_SIGNALS:
    /// Also when the same paint is chosen again, which means a fresh dip.
    void paint_chosen(const QString& pigment);

  private:
    /// The colours of a tube's icon.
    struct Colours {
        pigment::Srgb8 paint{}, tint{};
        friend bool operator==(const Colours&, const Colours&) = default;
    };
    static QIcon icon_of(const Colours& colours, double pixel_ratio);

    QListWidget* list_ = nullptr;
    std::vector<Colours> shown_;  ///< of each row
};

}  // namespace pastoso::panels
