// The mixing well in a panel of its own, which may be moved to another side or float beside the window.
#pragma once

#include <vector>

class QAction;
class QDockWidget;
class QWidget;

namespace pastoso::panels {

/// `well` shows the paint and is painted on; below it stand buttons for what is done to the brush and to
/// the well. The panel owns `well`, which takes all the room there is.
QDockWidget* well_panel(QWidget* well, const std::vector<QAction*>& of_brush,
                        const std::vector<QAction*>& of_well);

}  // namespace pastoso::panels
