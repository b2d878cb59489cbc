// How a painter changes the colour of what is dry: by a glaze over it, or by other pigments in it.
#pragma once

#include "document/actions/table.hpp"
#include "document/paint_recipe.hpp"
#include "layers/adjusting.hpp"

namespace pastoso::document {

struct LivingPainting;
struct UndoStep;

/// Adjusts the dry paint of the active layer, where it is selected and not masked, with paint of the
/// medium in hand (layers/adjusting.hpp). What comes is out of the tubes, as much as leaves that much
/// when it dries; what goes is wiped off. Wet paint stays as it is, on a surface that a glaze raises.
struct AdjustDryPaint {
    PaintRecipe paint{};
    layers::Adjustment way{};
    friend bool operator==(const AdjustDryPaint&, const AdjustDryPaint&) = default;
};

inline constexpr double kLeastGlaze_mm = 0.001;

using AdjustActions = ActionList<AdjustDryPaint>;

void check_whole(const AdjustDryPaint& adjust);
/// Throws InputError for a layer that is locked or hidden, and for a medium of which next to nothing is
/// left when it dries. apply() throws it for a layer without dry paint.
void check_possible(const AdjustDryPaint& adjust, const LivingPainting& painting);
UndoStep undo_step(const AdjustDryPaint& adjust, const LivingPainting& painting);
void apply(const AdjustDryPaint& adjust, LivingPainting& painting);

template <>
struct Table<layers::Glaze> {
    static constexpr std::string_view kName = "glaze";
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&layers::Glaze::thickness_mm>>{
            "thickness_mm", core::Pattern<0>("thickness of the glaze"), "mm", kLeastGlaze_mm,
            layers::kMostGlaze_mm, Presence::Written, "when it is dry"});
    }
};

template <>
struct Table<layers::PaintExchange> {
    static constexpr std::string_view kName = "exchange";
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&layers::PaintExchange::share>>{
            "share", core::Pattern<0>("share of the dry paint"), "", 0.0, 1.0, Presence::Written,
            "of its volume, that becomes the other paint"});
    }
};

template <>
struct Table<AdjustDryPaint> {
    static constexpr ActionTraits kTraits =
        change("adjust_dry_paint", 15, step_name("Dry paint adjusted"),
               "changes the colour of what is dry on the active layer, where it is selected, with paint "
               "of the medium in hand: by a dry coat over it, or by a share of it that becomes that "
               "paint ([0092](decisions/0092-adjusted-dry-paint.md))");
    static constexpr void fields(auto&& visit) {
        visit(Value<At<&AdjustDryPaint::paint>>{"paint", "paint", Presence::Required});
        visit(OneOf<At<&AdjustDryPaint::way>>{"way", "way of adjusting"});
    }
};

}  // namespace pastoso::document
