// The canvas itself: how it leans, its size, and which way round it is.
#pragma once

#include "core/orientation.hpp"
#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"
#include "document/undo_step.hpp"

#include <type_traits>

namespace pastoso::document {

struct LivingPainting;
struct PaintingValue;

inline constexpr double kMinCanvasSide_mm = 1.0;
inline constexpr double kMaxCanvasSide_mm = 5000.0;

struct TiltCanvas {
    double tilt_deg = 0.0;        ///< 0 flat, 90 upright
    double direction_deg = 90.0;  ///< where down points on the canvas: 0 right, 90 to the lower edge
    friend bool operator==(const TiltCanvas&, const TiltCanvas&) = default;
};
/// The canvas becomes this rectangle of its own millimetres, in whole cells. What is added is bare: more
/// of the same cloth, or the outermost heights of an image going on; what is cut off is wiped off. The
/// selection and the tracing come along. Guides, symmetry and fan stay at their millimetres, which count
/// from the new corner.
struct ResizeCanvas {
    double x_mm = 0.0, y_mm = 0.0;
    double width_mm = 0.0, height_mm = 0.0;
    friend bool operator==(const ResizeCanvas&, const ResizeCanvas&) = default;
};

/// Mirrors or turns the canvas with all that lies on it, to the bit: cloth, layers, selection and
/// tracing. Guides, symmetry, fan and tilt stay as they are in its new millimetres.
struct TurnCanvas {
    core::Orientation turn;
    friend bool operator==(const TurnCanvas&, const TurnCanvas&) = default;
};

/// Draws the canvas out with all that lies on it, and makes it of finer or coarser cells: layers,
/// selection and tracing. Paint keeps its thickness. The cloth, or its image, is drawn out with it.
/// Guides, symmetry and fan stay at their millimetres.
struct ScaleCanvas {
    double scale_x = 1.0, scale_y = 1.0;  ///< of the sides in mm
    double finer = 1.0;                   ///< cells a millimetre, times those there were
    friend bool operator==(const ScaleCanvas&, const ScaleCanvas&) = default;
};
inline constexpr double kLeastCanvasScale = 0.05, kMostCanvasScale = 20.0;

/// Turns what lies on the canvas about its middle by any angle: layers, selection and tracing. The
/// canvas becomes the upright one around it, or keeps its size; what comes to lie beyond it is wiped
/// off, what is beside it is bare. The cloth, or its image, is turned with it. Guides, symmetry and
/// fan stay at their millimetres.
struct RotateCanvas {
    double turn_deg = 0.0;  ///< clockwise
    bool keeps_size = false;
    friend bool operator==(const RotateCanvas&, const RotateCanvas&) = default;
};

using CanvasActions = ActionList<TiltCanvas, ResizeCanvas, TurnCanvas, ScaleCanvas, RotateCanvas>;

void put_in_hand(const TiltCanvas& tilt, PaintingValue& painting);
TiltCanvas in_hand(std::type_identity<TiltCanvas>, const PaintingValue& painting);
void apply(const TiltCanvas& tilt, LivingPainting& painting);
void apply(const ResizeCanvas& resize, LivingPainting& painting);
bool changes_anything(const TurnCanvas& turn, const LivingPainting& painting);
UndoStep undo_step(const TurnCanvas& turn, const LivingPainting& painting);
void apply(const TurnCanvas& turn, LivingPainting& painting);
bool changes_anything(const ScaleCanvas& scale, const LivingPainting& painting);
void apply(const ScaleCanvas& scale, LivingPainting& painting);
bool changes_anything(const RotateCanvas& rotate, const LivingPainting& painting);
void apply(const RotateCanvas& rotate, LivingPainting& painting);

template <>
struct Table<TiltCanvas> {
    static constexpr ActionTraits kTraits = setting("tilt_canvas", 1, "leans the canvas");
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&TiltCanvas::tilt_deg>>{"tilt_deg", core::Pattern<0>("tilt of the canvas"),
                                                core::Pattern<0>("degrees"), 0.0, 90.0,
                                                Presence::Required, "0 flat, 90 upright"});
        visit(Number<At<&TiltCanvas::direction_deg>>{
            "direction_deg", core::Pattern<0>("direction of the tilt"), core::Pattern<0>("degrees"),
            -360.0, 360.0, Presence::Written, "where down points: 0 right, 90 to the lower edge"});
    }
};

template <>
struct Table<ResizeCanvas> {
    static constexpr ActionTraits kTraits = change(
        "resize_canvas", 6, step_name("Size of the canvas"),
        "the canvas becomes this rectangle of its own millimetres, in whole cells. What is added is "
        "bare, more of the same cloth; what is cut off is counted as wiped off. Millimetres count "
        "from the new corner ever after");
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Number<At<&ResizeCanvas::x_mm>>{"x_mm", core::Pattern<0>("x of the new canvas"), "mm",
                                              -kFar_mm, kFar_mm, Written});
        visit(Number<At<&ResizeCanvas::y_mm>>{"y_mm", core::Pattern<0>("y of the new canvas"), "mm",
                                              -kFar_mm, kFar_mm, Written});
        visit(Number<At<&ResizeCanvas::width_mm>>{"width_mm",
                                                  core::Pattern<0>("width of the new canvas"), "mm",
                                                  kMinCanvasSide_mm, kMaxCanvasSide_mm, Required});
        visit(Number<At<&ResizeCanvas::height_mm>>{"height_mm",
                                                   core::Pattern<0>("height of the new canvas"), "mm",
                                                   kMinCanvasSide_mm, kMaxCanvasSide_mm, Required});
    }
};

template <>
struct Table<TurnCanvas> {
    static constexpr std::string_view kMirrored = step_name("Canvas mirrored");
    static constexpr ActionTraits kTraits = possible_change(
        "turn_canvas", 12, step_name("Canvas turned"),
        "the canvas with all that lies on it is mirrored left for right, then turned clockwise; every "
        "cell keeps all that it holds ([0082](decisions/0082-turned-canvases.md)). Millimetres count "
        "from the new corner ever after");
    static constexpr void fields(auto&& visit) {
        using core::Orientation;
        visit(Truth<At<&TurnCanvas::turn, &Orientation::mirrored>>{"mirrored", "mirrored",
                                                                   Presence::Optional});
        visit(Whole<At<&TurnCanvas::turn, &Orientation::quarter_turns>>{
            "quarter_turns", core::Pattern<0>("number of quarter turns"), 0, 3, Presence::Optional});
    }
};

template <>
struct Table<ScaleCanvas> {
    static constexpr ActionTraits kTraits = possible_change(
        "scale_canvas", 13, step_name("Painting scaled"),
        "the canvas with all that lies on it is drawn out, and made of finer or coarser cells; paint "
        "keeps its thickness ([0085](decisions/0085-scaled-canvases.md)). Millimetres count on the new "
        "canvas ever after");
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Number<At<&ScaleCanvas::scale_x>>{"scale_x", core::Pattern<0>("scale of the width"), "",
                                                kLeastCanvasScale, kMostCanvasScale, Optional});
        visit(Number<At<&ScaleCanvas::scale_y>>{"scale_y", core::Pattern<0>("scale of the height"), "",
                                                kLeastCanvasScale, kMostCanvasScale, Optional});
        visit(Number<At<&ScaleCanvas::finer>>{"finer", core::Pattern<0>("change of the resolution"), "",
                                              kLeastCanvasScale, kMostCanvasScale, Optional,
                                              "cells a millimetre, times those there were"});
    }
};

template <>
struct Table<RotateCanvas> {
    static constexpr ActionTraits kTraits = possible_change(
        "rotate_canvas", 14, step_name("Painting rotated"),
        "what lies on the canvas is turned about its middle, and the canvas becomes the "
        "upright one around it; paint keeps its thickness "
        "([0088](decisions/0088-perspective-and-rotation.md)). Millimetres count from the "
        "new corner ever after");
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&RotateCanvas::turn_deg>>{"turn_deg", core::Pattern<0>("turn of the canvas"),
                                                  core::Pattern<0>("degrees"), -360.0, 360.0,
                                                  Presence::Required, "clockwise"});
        visit(Truth<At<&RotateCanvas::keeps_size>>{"keeps_size", "size kept", Presence::Optional,
                                                   "of the canvas; what lies beyond it is wiped off"});
    }
};

}  // namespace pastoso::document
