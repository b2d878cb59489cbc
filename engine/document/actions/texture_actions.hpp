// How a painter gives what is painted on a relief: sand, modelling paste, a picture pressed in.
#pragma once

#include "document/actions/picture_actions.hpp"
#include "document/actions/table.hpp"
#include "document/paint_recipe.hpp"
#include "layers/texture/texture.hpp"

namespace pastoso::document {

struct LivingPainting;
struct UndoStep;

/// Lays a coat of paint as a texture onto the active layer, over what is selected, or over all of the
/// canvas: dry at once, and as thick then as it was laid. Wet paint below it is dry, too. Its paint is
/// of the medium in hand, as strong as that is, and comes out of the tubes.
struct LayTexture {
    PaintRecipe paint{};
    layers::Texture texture{};
    friend bool operator==(const LayTexture&, const LayTexture&) = default;
};

inline constexpr double kLeastGrain_mm = 0.1;
inline constexpr double kMostGrain_mm = 2.0;
inline constexpr double kLeastTexture_mm = 0.05;
inline constexpr double kMostTexture_mm = 3.0;
inline constexpr double kLeastRidges_mm = 0.5;
inline constexpr double kMostRidges_mm = 50.0;

using TextureActions = ActionList<LayTexture>;

void check_whole(const LayTexture& lay);
void check_possible(const LayTexture& lay, const LivingPainting& painting);
UndoStep undo_step(const LayTexture& lay, const LivingPainting& painting);
void apply(const LayTexture& lay, LivingPainting& painting);

template <>
struct Table<layers::SandTexture> {
    static constexpr std::string_view kName = "sand";
    static constexpr void fields(auto&& visit) {
        using Sand = layers::SandTexture;
        visit(Number<At<&Sand::grain_mm>>{"grain_mm", core::Pattern<0>("diameter of the grains"), "mm",
                                          kLeastGrain_mm, kMostGrain_mm, Presence::Written, "the mean"});
        visit(Whole<At<&Sand::seed>>{"seed", core::Pattern<0>("seed of the texture"), 0, UINT32_MAX,
                                     Presence::Written, "which grains"});
    }
};

template <>
struct Table<layers::KnifedTexture> {
    static constexpr std::string_view kName = "knifed";
    static constexpr void fields(auto&& visit) {
        using Knifed = layers::KnifedTexture;
        using enum Presence;
        visit(Number<At<&Knifed::height_mm>>{"height_mm", core::Pattern<0>("height of the texture"),
                                             "mm", kLeastTexture_mm, kMostTexture_mm, Written,
                                             "no place is higher"});
        visit(Number<At<&Knifed::spacing_mm>>{"spacing_mm", core::Pattern<0>("spacing of the ridges"),
                                              "mm", kLeastRidges_mm, kMostRidges_mm, Written,
                                              "a pass of the knife is six times as broad"});
        visit(Number<At<&Knifed::direction_deg>>{
            "direction_deg", core::Pattern<0>("direction of the knife"), core::Pattern<0>("degrees"),
            -360.0, 360.0, Written, "0 right, 90 down"});
        visit(Whole<At<&Knifed::seed>>{"seed", core::Pattern<0>("seed of the texture"), 0, UINT32_MAX,
                                       Written, "which passes"});
    }
};

template <>
struct Table<layers::PressedTexture> {
    static constexpr std::string_view kName = "pressed";
    static constexpr void fields(auto&& visit) {
        using Pressed = layers::PressedTexture;
        using enum Presence;
        visit(Part<At<&Pressed::place>>{});
        visit(Number<At<&Pressed::height_mm>>{"relief_mm", core::Pattern<0>("height of the texture"),
                                              "mm", kLeastTexture_mm, kMostTexture_mm, Written,
                                              "where the picture is white"});
        visit(Truth<At<&Pressed::dark_raised>>{"dark_raised", "dark raised", Optional,
                                               "where it is black, the other way round"});
        visit(Value<At<&Pressed::picture>>{"png", "picture", Required, "as in `paint_picture`"});
    }
};

template <>
struct Table<LayTexture> {
    static constexpr ActionTraits kTraits =
        change("lay_texture", 14, step_name("Texture laid"),
               "lays paint, of the medium in hand, as a relief onto the active layer, over what is "
               "selected, dry "
               "at once and no thinner for it; it comes out of the tubes "
               "([0089](decisions/0089-texture-paste.md))");
    static constexpr void fields(auto&& visit) {
        visit(Value<At<&LayTexture::paint>>{"paint", "paint", Presence::Required});
        visit(OneOf<At<&LayTexture::texture>>{"form", "texture"});
    }
};

}  // namespace pastoso::document
