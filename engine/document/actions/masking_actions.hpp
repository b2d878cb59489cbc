// How a painter masks parts of the canvas with fluid and tape, and peels them off.
#pragma once

#include "document/actions/selection_actions.hpp"
#include "document/undo_step.hpp"

namespace pastoso::document {

inline constexpr double kLeastStripe_mm = 0.01;
inline constexpr double kMostStripe_mm = 1000.0;

enum class MaskingForm { Fluid, Tape };

// They keep to what is selected, as tools do; of soft edges, to what is selected by half or more.

/// Masking fluid along the way of a round nib, or a strip of tape, which has straight ends; or what is
/// peeled along that way.
struct MaskStripe {
    std::vector<CanvasPoint> line{};  ///< 1 to kMostOutlinePoints
    double width_mm = 5.0;            ///< kLeastStripe_mm to kMostStripe_mm
    bool straight_ends = false;
    bool peels = false;
    friend bool operator==(const MaskStripe&, const MaskStripe&) = default;
};
struct MaskSelection {  ///< all that is selected, with fluid; nothing where nothing is
    friend bool operator==(const MaskSelection&, const MaskSelection&) = default;
};
struct SelectMasked {  ///< what is masked; where nothing is, nothing happens
    Combination how = Combination::Replace;
    friend bool operator==(const SelectMasked&, const SelectMasked&) = default;
};
struct PeelMasking {  ///< all of it, selected or not
    friend bool operator==(const PeelMasking&, const PeelMasking&) = default;
};

using MaskingActions = ActionList<MaskStripe, MaskSelection, SelectMasked, PeelMasking>;

void check_whole(const MaskStripe& stripe);
UndoStep undo_step(const MaskStripe& stripe, const LivingPainting& painting);
bool changes_anything(const MaskSelection& mask, const LivingPainting& painting);
bool changes_anything(const SelectMasked& select, const LivingPainting& painting);
bool changes_anything(const PeelMasking& peel, const LivingPainting& painting);
void apply(const MaskStripe& stripe, LivingPainting& painting);
void apply(const MaskSelection& mask, LivingPainting& painting);
void apply(const SelectMasked& select, LivingPainting& painting);
void apply(const PeelMasking& peel, LivingPainting& painting);

template <>
struct Table<MaskStripe> {
    static constexpr ActionTraits kTraits =
        change("mask_stripe", 14, step_name("Masking fluid"),
               "masks what the stripe goes over, as far as it is selected: neither tools nor flow nor "
               "drying reach the paint there ([0087](decisions/0087-masks.md))");
    static constexpr std::string_view kTape = step_name("Masking tape");
    static constexpr std::string_view kPeeled = step_name("Masking peeled off");
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Value<At<&MaskStripe::line>>{"line_mm", "line of the masking", Required,
                                           "1 to 20 000 points `[x, y]`"});
        visit(Number<At<&MaskStripe::width_mm>>{"width_mm", core::Pattern<0>("width of the masking"),
                                                "mm", kLeastStripe_mm, kMostStripe_mm, Required});
        visit(Truth<At<&MaskStripe::straight_ends>>{
            "straight_ends", "straight ends", Optional,
            "of tape, which ends straight across the first and the last point; else half a disc is "
            "around them"});
        visit(Truth<At<&MaskStripe::peels>>{"peels", "peels", Optional,
                                            "what is masked there is peeled off instead"});
    }
};

template <>
struct Table<MaskSelection> {
    static constexpr ActionTraits kTraits = possible_change(
        "mask_selection", 14, step_name("Selection masked"), "masks all that is selected, besides");
    static constexpr void fields(auto&&) {}
};

template <>
struct Table<SelectMasked> {
    static constexpr ActionTraits kTraits =
        possible_change("select_masked", 14, step_name("Selection"), "selects what is masked");
    static constexpr void fields(auto&& visit) { visit(kWayToSelect<&SelectMasked::how>); }
};

template <>
struct Table<PeelMasking> {
    static constexpr ActionTraits kTraits =
        possible_change("peel_masking", 14, step_name("Masking peeled off"), "nothing is masked then");
    static constexpr void fields(auto&&) {}
};

}  // namespace pastoso::document
