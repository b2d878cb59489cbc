// The pen on the canvas and in the mixing well. Recordings tell what it does from touch to lift as a
// stroke (docs/stroke-format.md).
#pragma once

#include "brush/pen_sample.hpp"
#include "document/actions/table.hpp"

namespace pastoso::document {

struct LivingPainting;
struct UndoStep;

/// The pen may leave the canvas, but not by more than this.
inline constexpr double kMaxPenPosition_mm = 20000.0;

inline constexpr double kLongestSession_s = 7.0 * 24.0 * 3600.0;

/// What the pen is on: the canvas, or the mixing well beside it. Both have their millimetres counted
/// from their own upper left corner.
enum class Surface { Canvas, Well };

struct PenDown {
    brush::PenSample sample;
    Surface surface = Surface::Canvas;  ///< until the pen lifts
    /// The surface, or what the brush changes of it: the stroke is an undo step once it touches, and
    /// none before.
    bool beside = false;
    friend bool operator==(const PenDown&, const PenDown&) = default;
};
struct PenMove {
    brush::PenSample sample;
    friend bool operator==(const PenMove&, const PenMove&) = default;
};
struct PenUp {
    friend bool operator==(const PenUp&, const PenUp&) = default;
};
/// What the stroke in progress has laid is taken back and laid again, all of it with that rotation: a
/// tip that turns with its path knows the path's direction a little after its start only. Once in a
/// stroke; without one it does nothing.
struct TurnStroke {
    double rotation_deg = 0.0;
    friend bool operator==(const TurnStroke&, const TurnStroke&) = default;
};

using PenActions = ActionList<PenDown, PenMove, PenUp, TurnStroke>;

/// Throw InputError for a pen without a brush in hand, on a layer that is hidden or locked, and for a
/// move that is earlier than the one before.
void check_possible(const PenDown& pen, const LivingPainting& painting);
void check_possible(const PenMove& pen, const LivingPainting& painting);
UndoStep undo_step(const PenDown& pen, const LivingPainting& painting);
void apply(const PenDown& pen, LivingPainting& painting);
void apply(const PenMove& pen, LivingPainting& painting);
void apply(const PenUp& pen, LivingPainting& painting);
void apply(const TurnStroke& turn, LivingPainting& painting);

/// Throws InputError when `next` is earlier than `previous`.
void check_time_order(const brush::PenSample& previous, const brush::PenSample& next);

template <>
struct Table<brush::PenSample> {
    using Sample = brush::PenSample;
    static constexpr void fields(auto&& visit) {
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Number<At<&Sample::time_s>>{"time_s", core::Pattern<0>("time of the pen"), "s", 0.0,
                                          kLongestSession_s, Presence::Required});
        visit(Number<At<&Sample::x_mm>>{"x_mm", core::Pattern<0>("x of the pen"), "mm", -kFar_mm,
                                        kFar_mm, Presence::Required});
        visit(Number<At<&Sample::y_mm>>{"y_mm", core::Pattern<0>("y of the pen"), "mm", -kFar_mm,
                                        kFar_mm, Presence::Required});
        visit(Number<At<&Sample::pressure>>{"pressure", core::Pattern<0>("pressure of the pen"), "", 0.0,
                                            1.0, Presence::Required});
        visit(Number<At<&Sample::tilt_x_deg>>{"tilt_x_deg", core::Pattern<0>("x tilt of the pen"),
                                              core::Pattern<0>("degrees"), -90.0, 90.0,
                                              Presence::Optional});
        visit(Number<At<&Sample::tilt_y_deg>>{"tilt_y_deg", core::Pattern<0>("y tilt of the pen"),
                                              core::Pattern<0>("degrees"), -90.0, 90.0,
                                              Presence::Optional});
        visit(Number<At<&Sample::rotation_deg>>{"rotation_deg", core::Pattern<0>("rotation of the pen"),
                                                core::Pattern<0>("degrees"), -3600.0, 3600.0,
                                                Presence::Optional});
        visit(Number<At<&Sample::wheel>>{"wheel", core::Pattern<0>("wheel of the pen"), "", -1.0, 1.0,
                                         Presence::Optional, "of an airbrush", 13});
    }
};

template <>
struct Table<PenDown> {
    static constexpr ActionTraits kTraits =
        change("stroke", 1, step_name("Stroke"), "the pen comes down");
    static constexpr std::string_view kStepInWell = step_name("Stroke in the mixing well");
    static constexpr UndoRole undo_role(const PenDown& pen) {
        return pen.beside ? UndoRole::MaybeStep : UndoRole::Step;
    }
    static constexpr void fields(auto&& visit) {
        visit(Part<At<&PenDown::sample>>{});
        visit(Value<At<&PenDown::surface>>{
            .key = "surface", .name = "surface", .presence = Presence::Optional, .since = 4});
        visit(Truth<At<&PenDown::beside>>{
            .key = "beside", .name = "beside", .presence = Presence::Optional, .since = 15});
    }
};

template <>
struct Table<PenMove> {
    static constexpr ActionTraits kTraits{.key = "stroke",
                                          .since = 1,
                                          .meaning = "the pen moves",
                                          .undo = UndoRole::NoStep,
                                          .step = "",
                                          .changes_painting = false,
                                          .stroke = StrokeRole::GoesOn,
                                          .in_set_up = false};
    static constexpr void fields(auto&& visit) { visit(Part<At<&PenMove::sample>>{}); }
};

template <>
struct Table<PenUp> {
    static constexpr ActionTraits kTraits{.key = "stroke",
                                          .since = 1,
                                          .meaning = "the pen lifts",
                                          .undo = UndoRole::NoStep,
                                          .step = "",
                                          .changes_painting = false,
                                          .stroke = StrokeRole::Ends,
                                          .in_set_up = false};
    static constexpr void fields(auto&&) {}
};

template <>
struct Table<TurnStroke> {
    static constexpr ActionTraits kTraits{
        .key = "turn_stroke",
        .since = 10,
        .meaning =
            "takes back what the stroke in progress has laid and lays it again, all of it with "
            "that rotation; once in a stroke",
        .undo = UndoRole::NoStep,
        .step = "",
        .changes_painting = false,
        .stroke = StrokeRole::GoesOn,
        .in_set_up = false};
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&TurnStroke::rotation_deg>>{
            "rotation_deg", core::Pattern<0>("rotation of the pen"), core::Pattern<0>("degrees"),
            -3600.0, 3600.0, Presence::Required});
    }
};

}  // namespace pastoso::document
