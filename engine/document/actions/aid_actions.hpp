// What steadies, leads and multiplies the hand.
#pragma once

#include "brush/pen_filter.hpp"
#include "brush/pen_guide.hpp"
#include "brush/symmetry.hpp"
#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"

#include <type_traits>

namespace pastoso::document {

struct PaintingValue;

/// A symmetry has at most this many copies beside their mirror images.
inline constexpr int kMostCopies = 16;

/// A guide has a direction.
inline constexpr double kShortestGuide_mm = 0.1;

struct SetStabiliser {  ///< steadies the hand, from the next stroke on
    brush::Stabiliser stabiliser;
    friend bool operator==(const SetStabiliser&, const SetStabiliser&) = default;
};
struct SetGuide {  ///< leads the pen on the canvas, from the next stroke on
    brush::PenGuide guide;
    friend bool operator==(const SetGuide&, const SetGuide&) = default;
};
/// Paints every stroke on the canvas from the next one on with several brushes at once. Each starts with
/// what the brush in hand holds, taken from the tubes, and is wiped when the stroke ends.
struct SetSymmetry {
    brush::Symmetry symmetry;
    friend bool operator==(const SetSymmetry&, const SetSymmetry&) = default;
};

using AidActions = ActionList<SetStabiliser, SetGuide, SetSymmetry>;

void check_whole(const SetGuide& set);
void put_in_hand(const SetStabiliser& set, PaintingValue& painting);
void put_in_hand(const SetGuide& set, PaintingValue& painting);
void put_in_hand(const SetSymmetry& set, PaintingValue& painting);
SetStabiliser in_hand(std::type_identity<SetStabiliser>, const PaintingValue& painting);
SetGuide in_hand(std::type_identity<SetGuide>, const PaintingValue& painting);
SetSymmetry in_hand(std::type_identity<SetSymmetry>, const PaintingValue& painting);

template <>
struct Table<SetStabiliser> {
    static constexpr ActionTraits kTraits =
        setting("set_stabiliser", 3, "steadies the hand, from the next stroke on");
    static constexpr void fields(auto&& visit) {
        using Stabiliser = brush::Stabiliser;
        visit(Number<At<&SetStabiliser::stabiliser, &Stabiliser::smoothing_ms>>{
            "smoothing_ms", core::Pattern<0>("smoothing of the stabiliser"), "ms", 0.0, 2000.0,
            Presence::Written, "added to the brush's own"});
        visit(Number<At<&SetStabiliser::stabiliser, &Stabiliser::string_mm>>{
            "string_mm", core::Pattern<0>("string of the stabiliser"), "mm", 0.0, 200.0,
            Presence::Written, "pulls the brush, where it is longer than the brush's own"});
    }
};

template <>
struct Table<std::monostate> {
    static constexpr std::string_view kName = "none";
    static constexpr void fields(auto&&) {}
};

template <>
struct Table<brush::StraightLine> {
    static constexpr std::string_view kName = "line";
    static constexpr void fields(auto&&) {}
};

template <>
struct Table<brush::Ruler> {
    static constexpr std::string_view kName = "ruler";
    static constexpr void fields(auto&& visit) {
        using brush::Ruler;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Pair<At<&Ruler::x1_mm>, At<&Ruler::y1_mm>>{"from_mm",
                                                         core::Pattern<0>("ruler's first point"), "mm",
                                                         -kFar_mm, kFar_mm, Presence::Required});
        visit(Pair<At<&Ruler::x2_mm>, At<&Ruler::y2_mm>>{
            "to_mm", core::Pattern<0>("ruler's second point"), "mm", -kFar_mm, kFar_mm,
            Presence::Required, "at least 0.1 mm from the first"});
    }
};

template <>
struct Table<brush::EllipseCurve> {
    static constexpr std::string_view kName = "ellipse";
    static constexpr void fields(auto&& visit) {
        using Ellipse = brush::EllipseCurve;
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Pair<At<&Ellipse::centre_x_mm>, At<&Ellipse::centre_y_mm>>{
            "centre_mm", core::Pattern<0>("ellipse's centre"), "mm", -kFar_mm, kFar_mm, Required});
        visit(Number<At<&Ellipse::half_width_mm>>{"half_width_mm",
                                                  core::Pattern<0>("half width of the ellipse"), "mm",
                                                  kShortestGuide_mm, kFar_mm, Required});
        visit(Number<At<&Ellipse::half_height_mm>>{"half_height_mm",
                                                   core::Pattern<0>("half height of the ellipse"), "mm",
                                                   kShortestGuide_mm, kFar_mm, Required});
        visit(Number<At<&Ellipse::turn_deg>>{"turn_deg", core::Pattern<0>("turn of the ellipse"),
                                             core::Pattern<0>("degrees"), -360.0, 360.0, Written});
    }
};

template <>
struct Table<brush::VanishingPoints> {
    static constexpr std::string_view kName = "perspective";
    static constexpr int kSince = 14;
    static constexpr void fields(auto&& visit) {
        using Points = brush::VanishingPoints;
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        constexpr core::Pattern<0> kDegrees("degrees");
        visit(Whole<At<&Points::count>>{"points", core::Pattern<0>("number of vanishing points"), 1, 3,
                                        Written});
        visit(Pair<At<&Points::x1_mm>, At<&Points::y1_mm>>{
            "first_mm", core::Pattern<0>("first vanishing point"), "mm", -kFar_mm, kFar_mm, Required});
        visit(Pair<At<&Points::x2_mm>, At<&Points::y2_mm>>{
            "second_mm", core::Pattern<0>("second vanishing point"), "mm", -kFar_mm, kFar_mm, Optional});
        visit(Pair<At<&Points::x3_mm>, At<&Points::y3_mm>>{
            "third_mm", core::Pattern<0>("third vanishing point"), "mm", -kFar_mm, kFar_mm, Optional});
        visit(Number<At<&Points::level_deg>>{"level_deg", core::Pattern<0>("direction of the horizon"),
                                             kDegrees, -360.0, 360.0, Written,
                                             "that of strokes under one point"});
        visit(Number<At<&Points::upright_deg>>{"upright_deg", core::Pattern<0>("direction of uprights"),
                                               kDegrees, -360.0, 360.0, Written,
                                               "that of strokes under one or two points"});
    }
};

template <>
struct Table<brush::Grid> {
    static constexpr std::string_view kName = "grid";
    static constexpr int kSince = 14;
    static constexpr void fields(auto&& visit) {
        using brush::Grid;
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        constexpr core::Pattern<0> kDegrees("degrees");
        visit(Pair<At<&Grid::x_mm>, At<&Grid::y_mm>>{"at_mm", core::Pattern<0>("grid's point"), "mm",
                                                     -kFar_mm, kFar_mm, Required,
                                                     "where two lines cross"});
        visit(Number<At<&Grid::direction_deg>>{"direction_deg",
                                               core::Pattern<0>("direction of the grid's first lines"),
                                               kDegrees, -360.0, 360.0, Written});
        visit(Number<At<&Grid::spacing_mm>>{"spacing_mm",
                                            core::Pattern<0>("spacing of the grid's first lines"), "mm",
                                            kShortestGuide_mm, kFar_mm, Written});
        visit(Number<At<&Grid::other_direction_deg>>{
            "other_direction_deg", core::Pattern<0>("direction of the grid's other lines"), kDegrees,
            -360.0, 360.0, Written});
        visit(Number<At<&Grid::other_spacing_mm>>{"other_spacing_mm",
                                                  core::Pattern<0>("spacing of the grid's other lines"),
                                                  "mm", kShortestGuide_mm, kFar_mm, Written});
    }
};

template <>
struct Table<SetGuide> {
    static constexpr ActionTraits kTraits =
        setting("set_guide", 3, "leads the pen on the canvas, from the next stroke on");
    static constexpr void fields(auto&& visit) {
        using Guide = brush::PenGuide;
        visit(OneOf<At<&SetGuide::guide, &Guide::form>>{"form", "guide"});
        visit(Number<At<&SetGuide::guide, &Guide::reach_mm>>{
            "reach_mm", core::Pattern<0>("reach of the guide"), "mm", 0.0, kMaxPenPosition_mm,
            Presence::Optional,
            "how near a ruler, an ellipse or a line of a grid a stroke has to start to run along it; "
            "others run beside it"});
        visit(Truth<At<&SetGuide::guide, &Guide::turn_across>>{
            "turn_across", "turn across the guide", Presence::Optional,
            "the width of the brush stands across it"});
        visit(Number<At<&SetGuide::guide, &Guide::strength>>{
            "strength", core::Pattern<0>("strength of the guide"), "", 0.0, 1.0, Presence::Optional,
            "how far it takes the pen from the hand's place to its own", 14});
    }
};

template <>
struct Table<SetSymmetry> {
    static constexpr ActionTraits kTraits =
        setting("set_symmetry", 3,
                "paints every stroke on the canvas with several brushes at once, from the next one on");
    template <auto kMember>
    using Here = At<&SetSymmetry::symmetry, kMember>;
    static constexpr void fields(auto&& visit) {
        using brush::Symmetry;
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Number<Here<&Symmetry::centre_x_mm>>{"centre_x_mm",
                                                   core::Pattern<0>("x of the centre of the symmetry"),
                                                   "mm", -kFar_mm, kFar_mm, Required});
        visit(Number<Here<&Symmetry::centre_y_mm>>{"centre_y_mm",
                                                   core::Pattern<0>("y of the centre of the symmetry"),
                                                   "mm", -kFar_mm, kFar_mm, Required});
        visit(Number<Here<&Symmetry::axis_deg>>{"axis_deg", core::Pattern<0>("axis of the symmetry"),
                                                core::Pattern<0>("degrees"), -360.0, 360.0, Optional,
                                                "direction of the mirror"});
        visit(
            Truth<Here<&Symmetry::mirror>>{"mirror", "mirror", Optional, "mirrors every copy as well"});
        visit(Whole<Here<&Symmetry::count>>{"count", core::Pattern<0>("number of the symmetry's copies"),
                                            1, kMostCopies, Optional, "turned evenly about the centre"});
    }
};

}  // namespace pastoso::document
