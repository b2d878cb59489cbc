// How a painter chooses what tools may change.
#pragma once

#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"
#include "grid/mask.hpp"

#include <cstddef>
#include <vector>

namespace pastoso::document {

struct LivingPainting;

/// Where no cell is selected, everything is: tools may change the whole canvas. Then Add and Intersect
/// are Replace, Subtract leaves all but the region. A selection of no cell at all is none.
using grid::Combination;

struct CanvasPoint {
    double x_mm = 0.0, y_mm = 0.0;
    friend bool operator==(const CanvasPoint&, const CanvasPoint&) = default;
};

/// Throws InputError, naming it, when a pen cannot come there.
void check_point(const core::Message& name, const CanvasPoint& point);

inline constexpr std::size_t kMostOutlinePoints = 20000;

/// Paint is never higher.
inline constexpr double kMostPaint_mm = 1000.0;

/// In CIEDE2000; black and white differ by so much.
inline constexpr double kMostDifference = 100.0;

struct SelectArea {  ///< what a closed line goes around: a rectangle's corners or a lasso
    std::vector<CanvasPoint> outline{};  ///< 3 to kMostOutlinePoints
    Combination how = Combination::Replace;
    friend bool operator==(const SelectArea&, const SelectArea&) = default;
};
/// Where the paint that the active layer holds and what is visible below it are so high together, wet
/// and dry, from the bare support on.
struct SelectByHeight {
    double least_mm = 0.0, most_mm = 0.0;  ///< both included, 0 to kMostPaint_mm
    Combination how = Combination::Replace;
    friend bool operator==(const SelectByHeight&, const SelectByHeight&) = default;
};
struct SelectByWetness {                   ///< where the wet paint of the active layer is so thick
    double least_mm = 0.0, most_mm = 0.0;  ///< both included, 0 to kMostPaint_mm
    Combination how = Combination::Replace;
    friend bool operator==(const SelectByWetness&, const SelectByWetness&) = default;
};
/// Where the active layer has paint, wet or dry, of layers::kLeastPaint_mm or more.
struct SelectPaint {
    Combination how = Combination::Replace;
    friend bool operator==(const SelectPaint&, const SelectPaint&) = default;
};
/// Where the painting, all that is visible of it, has nearly the colour that the cell at a place has, or
/// the nearest one on the canvas: as the paint looks under even daylight.
struct SelectSimilarColour {
    double x_mm = 0.0, y_mm = 0.0;
    double difference = 10.0;  ///< CIEDE2000, included, 0 to kMostDifference
    bool connected = true;     ///< only what hangs together with the place, cell by cell
    Combination how = Combination::Replace;
    friend bool operator==(const SelectSimilarColour&, const SelectSimilarColour&) = default;
};
struct InvertSelection {
    friend bool operator==(const InvertSelection&, const InvertSelection&) = default;
};
struct SelectAll {  ///< ends the selection
    friend bool operator==(const SelectAll&, const SelectAll&) = default;
};

using SelectionActions = ActionList<SelectArea, SelectByHeight, SelectByWetness, SelectPaint,
                                    SelectSimilarColour, InvertSelection, SelectAll>;

void check_whole(const SelectArea& select);
void check_whole(const SelectByHeight& select);
void check_whole(const SelectByWetness& select);
bool changes_anything(const InvertSelection& invert, const LivingPainting& painting);
bool changes_anything(const SelectAll& select, const LivingPainting& painting);
void apply(const SelectArea& select, LivingPainting& painting);
void apply(const SelectByHeight& select, LivingPainting& painting);
void apply(const SelectByWetness& select, LivingPainting& painting);
void apply(const SelectPaint& select, LivingPainting& painting);
void apply(const SelectSimilarColour& select, LivingPainting& painting);
void apply(const InvertSelection& invert, LivingPainting& painting);
void apply(const SelectAll& select, LivingPainting& painting);

template <auto kMember>
inline constexpr Value<At<kMember>> kWayToSelect{"how", "way to select", Presence::Optional,
                                                 "`\"replace\"` (default), `\"add\"`, `\"subtract\"` or "
                                                 "`\"intersect\"`, with what is selected already"};

template <>
struct Table<SelectArea> {
    static constexpr ActionTraits kTraits =
        change("select_area", 6, step_name("Selection"),
               "tools change nothing but what the closed line goes around");
    static constexpr void fields(auto&& visit) {
        visit(Value<At<&SelectArea::outline>>{"outline_mm", "outline", Presence::Required,
                                              "3 to 20 000 points `[x, y]`"});
        visit(kWayToSelect<&SelectArea::how>);
    }
};

template <>
struct Table<SelectByHeight> {
    static constexpr ActionTraits kTraits =
        change("select_by_height", 6, step_name("Selection"),
               "where the paint of the active layer and of what is visible below it, wet and dry, is so "
               "high above the bare support");
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&SelectByHeight::least_mm>>{"least_mm", core::Pattern<0>("least height"), "mm",
                                                    0.0, kMostPaint_mm, Presence::Required});
        visit(Number<At<&SelectByHeight::most_mm>>{"most_mm", core::Pattern<0>("most height"), "mm", 0.0,
                                                   kMostPaint_mm, Presence::Required, "both included"});
        visit(kWayToSelect<&SelectByHeight::how>);
    }
};

template <>
struct Table<SelectByWetness> {
    static constexpr ActionTraits kTraits =
        change("select_by_wetness", 6, step_name("Selection"),
               "where the wet paint of the active layer is so thick");
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&SelectByWetness::least_mm>>{"least_mm",
                                                     core::Pattern<0>("least thickness of wet paint"),
                                                     "mm", 0.0, kMostPaint_mm, Presence::Required});
        visit(Number<At<&SelectByWetness::most_mm>>{
            "most_mm", core::Pattern<0>("most thickness of wet paint"), "mm", 0.0, kMostPaint_mm,
            Presence::Required, "both included"});
        visit(kWayToSelect<&SelectByWetness::how>);
    }
};

template <>
struct Table<SelectPaint> {
    static constexpr ActionTraits kTraits = change("select_paint", 12, step_name("Selection"),
                                                   "where the active layer has paint, wet or dry");
    static constexpr void fields(auto&& visit) { visit(kWayToSelect<&SelectPaint::how>); }
};

template <>
struct Table<SelectSimilarColour> {
    static constexpr ActionTraits kTraits =
        change("select_similar_colour", 12, step_name("Selection"),
               "where the painting, all that is visible of it, has nearly the colour that it has at a "
               "place, under even daylight");
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Number<At<&SelectSimilarColour::x_mm>>{"x_mm", core::Pattern<0>("x of the colour's place"),
                                                     "mm", -kFar_mm, kFar_mm, Required});
        visit(Number<At<&SelectSimilarColour::y_mm>>{"y_mm", core::Pattern<0>("y of the colour's place"),
                                                     "mm", -kFar_mm, kFar_mm, Required});
        visit(Number<At<&SelectSimilarColour::difference>>{
            "difference", core::Pattern<0>("difference of the colour"), "", 0.0, kMostDifference,
            Written, "in CIEDE2000, included"});
        visit(Truth<At<&SelectSimilarColour::connected>>{
            "connected", "connected", Written, "only what hangs together with the place, cell by cell"});
        visit(kWayToSelect<&SelectSimilarColour::how>);
    }
};

template <>
struct Table<InvertSelection> {
    static constexpr ActionTraits kTraits = possible_change(
        "invert_selection", 6, step_name("Selection"),
        "selects what was not selected; a selection of nothing is none: everything may be changed");
    static constexpr void fields(auto&&) {}
};

template <>
struct Table<SelectAll> {
    static constexpr ActionTraits kTraits =
        possible_change("select_all", 6, step_name("Selection"), "ends the selection");
    static constexpr void fields(auto&&) {}
};

}  // namespace pastoso::document
