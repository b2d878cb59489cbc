// How a painter covers an area with an even film of wet paint at once.
#pragma once

#include "document/actions/layer_actions.hpp"
#include "document/actions/selection_actions.hpp"
#include "document/actions/table.hpp"
#include "document/paint_recipe.hpp"

#include <string>
#include <vector>

namespace pastoso::document {

struct LivingPainting;
struct UndoStep;

inline constexpr double kLeastFill_mm = 0.01;
inline constexpr double kMostFill_mm = 2.0;

/// A gradient's line is at least so long.
inline constexpr double kLeastGradient_mm = 0.1;

/// Pours wet paint of the medium in hand onto the active layer, an even film over what is selected, or
/// over all of the canvas: onto wet paint as layers::merged() does. It comes out of the tubes.
struct FillWithPaint {
    PaintRecipe paint{};
    double thickness_mm = 0.2;  ///< kLeastFill_mm to kMostFill_mm
    PaintRecipe second{};       ///< where the line ends; without a line it does not count
    /// None, or where the paint begins to become the second one and where it is that alone: between both
    /// they are mixed in proportion to the way along the line.
    std::vector<CanvasPoint> line{};
    friend bool operator==(const FillWithPaint&, const FillWithPaint&) = default;
};

/// Lays an even coat of paint of the medium in hand over the whole canvas, dry at once, below all layers
/// and on one of its own. It comes out of the tubes.
struct ToneGround {
    PaintRecipe paint{};
    double thickness_mm = 0.1;  ///< while it is wet; kLeastFill_mm to kMostFill_mm
    std::string name;           ///< of its layer
    friend bool operator==(const ToneGround&, const ToneGround&) = default;
};

using FillActions = ActionList<FillWithPaint, ToneGround>;

void check_whole(const FillWithPaint& fill);
void check_possible(const FillWithPaint& fill, const LivingPainting& painting);
UndoStep undo_step(const FillWithPaint& fill, const LivingPainting& painting);
void apply(const FillWithPaint& fill, LivingPainting& painting);
void check_whole(const ToneGround& tone);
void apply(const ToneGround& tone, LivingPainting& painting);

template <>
struct Table<FillWithPaint> {
    static constexpr ActionTraits kTraits = change(
        "fill_with_paint", 12, step_name("Filled with paint"),
        "pours an even film of wet paint, of the medium in hand, onto the active layer, over what "
        "is selected; it comes out of the tubes");
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Value<At<&FillWithPaint::paint>>{"paint", "paint", Required});
        visit(Number<At<&FillWithPaint::thickness_mm>>{"thickness_mm",
                                                       core::Pattern<0>("thickness of the film"), "mm",
                                                       kLeastFill_mm, kMostFill_mm, Written});
        visit(Value<At<&FillWithPaint::second>>{"second", "second paint", Optional,
                                                "that a gradient ends in"});
        visit(Value<At<&FillWithPaint::line>>{
            "line_mm", "line of the gradient", Optional,
            "two points `[x, y]`: from the first paint to the second one; none: all is of the first"});
    }
};

template <>
struct Table<ToneGround> {
    static constexpr ActionTraits kTraits = change(
        "tone_ground", 13, step_name("Ground toned"),
        "lays an even dry coat of paint, of the medium in hand, over the whole canvas, below all layers "
        "and on one of its own; it comes out of the tubes");
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Value<At<&ToneGround::paint>>{"paint", "paint", Required});
        visit(Number<At<&ToneGround::thickness_mm>>{
            "thickness_mm", core::Pattern<0>("thickness of the film"), "mm", kLeastFill_mm, kMostFill_mm,
            Written, "while it is wet"});
        visit(Text<At<&ToneGround::name>>{"name", core::Pattern<0>("name of a layer"), kMostLayerName,
                                          Required});
    }
};

}  // namespace pastoso::document
