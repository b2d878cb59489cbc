// The mixing well in a panel of its own, which may be moved to another side or float beside the window.
#pragma once

#include <vector>

class QAction;
class QDockWidget;
class QWidget;

namespace pastoso::panels {

/// `well` shows the paint and is painted on; below it stand buttons for the actions. The panel owns
/// `well`.
QDockWidget* well_panel(QWidget* well, const std::vector<QAction*>& actions);

}  // namespace pastoso::panels
