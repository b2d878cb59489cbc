// How a painter makes the selection wider or narrower, takes its outline alone, or makes its edge soft.
#pragma once

#include "document/actions/table.hpp"

namespace pastoso::document {

struct LivingPainting;

inline constexpr double kLeastMargin_mm = 0.01;
inline constexpr double kMostMargin_mm = 1000.0;

// The same in every direction (grid/mask_margins.hpp); the edge of the canvas is no outline. Nothing
// happens where nothing is selected. All are kLeastMargin_mm to kMostMargin_mm wide. Of a soft edge the
// first three take what is selected by half or more; theirs is hard again.

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

/// A soft edge as wide as the radius on either side of the outline (grid/feathering.hpp): there cells
/// are selected by a share, and tools, fills and cuts change them by that share of what they would.
struct FeatherSelection {
    double radius_mm = 1.0;
    friend bool operator==(const FeatherSelection&, const FeatherSelection&) = default;
};

using MarginActions = ActionList<GrowSelection, ShrinkSelection, BorderSelection, FeatherSelection>;

bool changes_anything(const GrowSelection& grow, const LivingPainting& painting);
bool changes_anything(const ShrinkSelection& shrink, const LivingPainting& painting);
bool changes_anything(const BorderSelection& border, const LivingPainting& painting);
bool changes_anything(const FeatherSelection& feather, const LivingPainting& painting);
void apply(const GrowSelection& grow, LivingPainting& painting);
void apply(const ShrinkSelection& shrink, LivingPainting& painting);
void apply(const BorderSelection& border, LivingPainting& painting);
void apply(const FeatherSelection& feather, LivingPainting& painting);

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

template <>
struct Table<FeatherSelection> {
    static constexpr ActionTraits kTraits =
        possible_change("feather_selection", 15, step_name("Selection"),
                        "the selection gets a soft edge, as wide as the radius on either side of its "
                        "outline: there cells are selected by a share "
                        "([0090](decisions/0090-feathered-selections.md))");
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&FeatherSelection::radius_mm>>{
            "radius_mm", core::Pattern<0>("radius of the feather"), "mm", kLeastMargin_mm,
            kMostMargin_mm, Presence::Required});
    }
};

}  // namespace pastoso::document
