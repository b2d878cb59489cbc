// The navigator: shows where the canvas's view is on the whole painting, and moves it.
#pragma once

#include "main/studio.hpp"
#include "session/overview.hpp"

#include <memory>

#include <QObject>
#include <QTimer>

class QDockWidget;

namespace pastoso::panels {
class NavigatorPanel;
}

namespace pastoso::main {

class Navigation : public QObject {
    Q_OBJECT
  public:
    /// `dock` holds `panel`.
    Navigation(Studio& studio, panels::NavigatorPanel* panel, QDockWidget* dock);

  private:
    void show_view();
    void want_picture();

    Studio& studio_;
    panels::NavigatorPanel* panel_;
    std::unique_ptr<session::OverviewPainter> painter_;
    std::shared_ptr<const document::Snapshot> pictured_;  ///< what the picture shows, or will
    pigment::Viewing viewing_;                            ///< and in which light
    QTimer changed_;                                      ///< soon after the paint
};

}  // namespace pastoso::main
