#include "tools/eraser_end.hpp"

#include <utility>

namespace pastoso::tools {

bool EraserEnd::turn_over(const std::string& tool, Easel& easel) {
    if (tool.empty() || in_use()) return false;
    const Hand& hand = easel.hand();
    before_ = Kept{preset_in_hand(hand), hand.brush_width_mm};
    const brush::Preset& wanted = brush::find_preset(tool);
    if (std::exchange(tool_, wanted.name) != wanted.name) width_mm_ = wanted.tip.width_mm;
    easel.take_brush(wanted, width_mm_);
    return true;
}

bool EraserEnd::turn_back(Easel& easel) {
    if (!in_use()) return false;
    const Kept before = *std::exchange(before_, std::nullopt);
    if (easel.hand().brush != tool_) return false;
    width_mm_ = easel.hand().brush_width_mm;
    easel.take_brush(before.preset, before.width_mm);
    return true;
}

}  // namespace pastoso::tools
