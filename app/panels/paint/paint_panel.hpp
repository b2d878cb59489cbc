// The tubes of paint.
#pragma once

#include <vector>

#include <QColor>
#include <QString>
#include <QWidget>

class QListWidget;

namespace pastoso::panels {

struct PaintEntry {
    QString pigment;  ///< Colour Index name, empty for the medium alone
    QString name;
    QColor masstone;  ///< thick, as it comes from the tube
    QColor tint;      ///< with white, where a dark pigment shows its hue
};

class PaintPanel : public QWidget {
    Q_OBJECT
  public:
    explicit PaintPanel(const std::vector<PaintEntry>& paints, QWidget* parent = nullptr);

    /// Shows what the brush is dipped in, without a signal; nothing when it is from no tube.
    void show_paint(const QString& pigment);

  Q_SIGNALS:
    /// Also when the same paint is chosen again, which means a fresh dip.
    void paint_chosen(const QString& pigment);

  private:
    QListWidget* list_ = nullptr;
};

}  // namespace pastoso::panels
