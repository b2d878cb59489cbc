#include "tools/eraser_end.hpp"

#include <utility>

namespace pastoso::tools {

bool EraserEnd::turn_over(const std::string& tool, Easel& easel) {
    if (tool.empty() || in_use()) return false;
    in_use_ = true;
    const brush::Preset& wanted = brush::find_preset(tool);
    if (std::exchange(tool_, wanted.name) != wanted.name) width_mm_ = wanted.tip.width_mm;
    easel.take_for_now(wanted, width_mm_);
    return true;
}

bool EraserEnd::turn_back(Easel& easel) {
    if (!std::exchange(in_use_, false)) return false;
    if (easel.hand().brush != tool_ || !easel.hand().brush_aside) return false;
    width_mm_ = easel.hand().brush_width_mm;
    easel.swap_brushes();
    return true;
}

}  // namespace pastoso::tools
