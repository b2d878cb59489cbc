#include "tools/hand.hpp"

#include "brush/preset.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::tools {
namespace {

/// Changes the hand as one action does; most change nothing.
struct HandChange {
    Hand& hand;

    void operator()(const document::TakeBrush& taken) const {
        const brush::Preset& preset = brush::find_preset(taken.preset);
        hand.brush = preset.name;
        hand.brush_width_mm = taken.size_mm > 0.0 ? taken.size_mm : preset.tip.width_mm;
    }
    void operator()(const document::LoadPaint& dip) const { hand.paint = dip.paint; }
    void operator()(const document::UseMedium& medium) const { hand.medium = medium.name; }
    void operator()(const document::TiltCanvas& tilt) const { hand.tilt = tilt; }
    void operator()(const document::SetDrying& drying) const { hand.air = drying.air; }
    void operator()(const document::SetStabiliser& set) const { hand.stabiliser = set.stabiliser; }
    void operator()(const document::SetSymmetry& set) const { hand.symmetry = set.symmetry; }
    void operator()(const document::SetGuide& set) const {
        hand.guide = set.guide;
        if (const auto* ruler = std::get_if<brush::Ruler>(&set.guide.form)) hand.ruler = *ruler;
    }
    template <class Other>
    void operator()(const Other&) const {}
};

}  // namespace

Hand hand_after(Hand hand, const std::vector<document::Event>& events) {
    for (const document::Event& event : events)
        std::visit(HandChange{hand}, event.action);
    return hand;
}

double stepped_brush_width_mm(double width_mm, int steps) {
    for (; steps > 0; --steps)
        width_mm += std::max(0.5, std::round(width_mm * 0.24) / 2.0);
    for (; steps < 0; ++steps)
        width_mm -= std::max(0.5, std::round(width_mm * 0.22) / 2.0);
    return std::clamp(width_mm, kSmallestBrush_mm, kLargestBrush_mm);
}

}  // namespace pastoso::tools
