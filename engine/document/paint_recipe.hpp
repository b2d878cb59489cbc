// What a painter mixes: paints by their parts.
#pragma once

#include <string>
#include <vector>

namespace pastoso::document {

/// One paint of a mixture: parts by volume at full strength.
struct Ingredient {
    std::string pigment;  ///< Colour Index name, for example "PB29", or a colour of sRGB, "#c03020"
    double parts = 1.0;   ///< > 0
    friend bool operator==(const Ingredient&, const Ingredient&) = default;
};

/// A mixture of paints thinned with clear medium.
struct PaintRecipe {
    std::vector<Ingredient> ingredients{};  ///< none: the medium alone
    /// Share of pigmented paint in the volume, the rest is clear medium; 0 < s <= 1.
    double strength = 1.0;
    friend bool operator==(const PaintRecipe&, const PaintRecipe&) = default;
};

/// Throws InputError for an unknown paint, and for parts or a strength out of range.
void check_paint(const PaintRecipe& paint);

}  // namespace pastoso::document
