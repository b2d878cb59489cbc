// How a painter makes the selection wider or narrower, or takes its outline alone.
#pragma once

#include "document/actions/table.hpp"

namespace pastoso::document {

struct LivingPainting;

inline constexpr double kLeastMargin_mm = 0.01;
inline constexpr double kMostMargin_mm = 1000.0;

// The same in every direction (grid/mask_margins.hpp); the edge of the canvas is no outline. Nothing
// happens where nothing is selected. All are kLeastMargin_mm to kMostMargin_mm wide.

struct GrowSelection {  ///< by all that lies so near
    double width_mm = 1.0;
    friend bool operator==(const GrowSelection&, const GrowSelection&) = default;
};
struct ShrinkSelection {  ///< by all that lies so near to what is not selected
    double width_mm = 1.0;
    friend bool operator==(const ShrinkSelection&, const ShrinkSelection&) = default;
};
struct BorderSelection {  ///< selects a band of that width, the outline in its middle
    double width_mm = 1.0;
    friend bool operator==(const BorderSelection&, const BorderSelection&) = default;
};

using MarginActions = ActionList<GrowSelection, ShrinkSelection, BorderSelection>;

bool changes_anything(const GrowSelection& grow, const LivingPainting& painting);
bool changes_anything(const ShrinkSelection& shrink, const LivingPainting& painting);
bool changes_anything(const BorderSelection& border, const LivingPainting& painting);
void apply(const GrowSelection& grow, LivingPainting& painting);
void apply(const ShrinkSelection& shrink, LivingPainting& painting);
void apply(const BorderSelection& border, LivingPainting& painting);

template <auto kMember>
inline constexpr Number<At<kMember>> kMarginWidth{
    "width_mm",        core::Pattern<0>("width of the margin"), "mm", kLeastMargin_mm, kMostMargin_mm,
    Presence::Required};

template <>
struct Table<GrowSelection> {
    static constexpr ActionTraits kTraits =
        possible_change("grow_selection", 12, step_name("Selection"),
                        "selects all that lies so near to what is selected, too");
    static constexpr void fields(auto&& visit) { visit(kMarginWidth<&GrowSelection::width_mm>); }
};

template <>
struct Table<ShrinkSelection> {
    static constexpr ActionTraits kTraits =
        possible_change("shrink_selection", 12, step_name("Selection"),
                        "selects no longer what lies so near to what is not selected");
    static constexpr void fields(auto&& visit) { visit(kMarginWidth<&ShrinkSelection::width_mm>); }
};

template <>
struct Table<BorderSelection> {
    static constexpr ActionTraits kTraits =
        possible_change("border_selection", 12, step_name("Selection"),
                        "selects a band so wide along the outline of what was selected, half of it on "
                        "either side");
    static constexpr void fields(auto&& visit) { visit(kMarginWidth<&BorderSelection::width_mm>); }
};

}  // namespace pastoso::document
