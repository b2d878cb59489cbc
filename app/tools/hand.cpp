#include "tools/hand.hpp"

#include "document/actions/actions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::tools {
namespace {

/// Changes the hand as one action does; what neither dips the brush nor is in the set-up changes
/// nothing.
struct HandChange {
    Hand& hand;

    void operator()(const document::TakeBrush& taken) const {
        const brush::Preset preset = document::preset_of(taken);
        hand.brush = preset.name;
        hand.own_preset = taken.definition.empty() ? std::nullopt : std::optional(preset);
        hand.brush_width_mm = taken.size_mm > 0.0 ? taken.size_mm : preset.tip.width_mm;
    }
    void operator()(const document::LayBrushAside& lay) const { hand.brush_aside = lay.brush; }
    void operator()(const document::SwapBrushes&) const {
        if (!hand.brush_aside) return;
        const document::TakeBrush taken = *std::exchange(hand.brush_aside, taken_of(hand));
        (*this)(taken);
    }
    void operator()(const document::LoadPaint& load) const {
        using Way = Dip::Way;
        const bool two = !load.second.ingredients.empty();
        hand.paint = load.paint;
        if (two) hand.second_paint = load.second;
        hand.dip.way = two && load.side_by_side ? Way::TwoSides
                       : two                    ? Way::HalfMixed
                       : load.tip_only          ? Way::Tip
                                                : Way::Full;
        hand.dip.fill = load.fill;
        if (hand.dip.way == Way::HalfMixed) hand.dip.second_share = load.second_share;
    }
    void operator()(const document::UseMedium& medium) const { hand.medium = medium; }
    void operator()(const document::TiltCanvas& tilt) const { hand.tilt = tilt; }
    void operator()(const document::SetDrying& drying) const { hand.air = drying.air; }
    void operator()(const document::SetStabiliser& set) const { hand.stabiliser = set.stabiliser; }
    void operator()(const document::SetSymmetry& set) const { hand.symmetry = set.symmetry; }
    void operator()(const document::SetGuide& set) const {
        hand.guide = set.guide;
        // A stroke drawn straight leaves what is laid where it is.
        if (std::holds_alternative<brush::StraightLine>(set.guide.form)) return;
        hand.laid = set.guide;
        hand.laid.turn_across = false;
    }
    template <class Other>
    requires(!document::Table<Other>::kTraits.in_set_up) void operator()(const Other&) const {}
};

}  // namespace

brush::Preset preset_in_hand(const Hand& hand) {
    return hand.own_preset ? *hand.own_preset : brush::find_preset(hand.brush);
}

brush::Preset sized_preset_in_hand(const Hand& hand) {
    return brush::resized(preset_in_hand(hand), hand.brush_width_mm);
}

document::LoadPaint load_of(const Hand& hand) {
    document::LoadPaint load;
    load.paint = hand.paint;
    load.fill = hand.dip.fill;
    load.tip_only = hand.dip.way == Dip::Way::Tip;
    if (hand.dip.way != Dip::Way::TwoSides && hand.dip.way != Dip::Way::HalfMixed) return load;
    constexpr double kHalfMixed = 0.6;
    load.second = hand.second_paint;
    load.side_by_side = hand.dip.way == Dip::Way::TwoSides;
    load.second_share = load.side_by_side ? 0.5 : hand.dip.second_share;
    load.share_variation = load.side_by_side ? 0.0 : kHalfMixed;
    return load;
}

document::TakeBrush taken_of(const Hand& hand, std::uint32_t seed) {
    document::TakeBrush take{hand.brush, hand.brush_width_mm, seed};
    if (hand.own_preset) take.definition = brush::preset_to_json(*hand.own_preset);
    return take;
}

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
