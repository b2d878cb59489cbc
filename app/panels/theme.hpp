// The look of the window: neutral greys, so that the eye judges the colours of the paint alone.
#pragma once

class QApplication;

namespace pastoso::panels {

void apply_theme(QApplication& application);

}  // namespace pastoso::panels
