// Where on the canvas the window is, how near and how turned: to see and to change.
#pragma once

#include <vector>

#include <QWidget>

class QAction;

namespace pastoso::panels {

class NavigatorMap;
class ValueRow;

class NavigatorPanel : public QWidget {
    Q_OBJECT
  public:
    /// Buttons for how near the canvas is, and for how it stands. The zoom's limits are screen pixels
    /// for a pixel of the canvas.
    NavigatorPanel(const std::vector<QAction*>& nearness, const std::vector<QAction*>& standing,
                   double least_zoom, double most_zoom, QWidget* parent = nullptr);

    NavigatorMap& map() { return *map_; }

    /// Without a signal. The angle is clockwise, -180 to 180.
    void show_view(double zoom, double angle_deg);

  Q_SIGNALS:
    void zoom_chosen(double zoom);
    void angle_chosen(double angle_deg);

  private:
    NavigatorMap* map_ = nullptr;
    ValueRow* zoom_ = nullptr;
    ValueRow* angle_ = nullptr;
};

}  // namespace pastoso::panels
