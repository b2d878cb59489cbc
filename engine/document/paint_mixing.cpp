#include "document/paint_mixing.hpp"

#include "document/actions/field_checks.hpp"
#include "pigment/paint_name.hpp"
#include "pigment/palette.hpp"

#include <vector>

namespace pastoso::document {
namespace {

/// More parts than this are a mistake of units, and tiny ones would vanish in the mixture.
constexpr double kLeastParts = 1e-6;
constexpr double kMostParts = 1e6;
constexpr double kLeastStrength = 1e-4;

}  // namespace

void check_paint(const PaintRecipe& paint) {
    for (const Ingredient& ingredient : paint.ingredients) {
        pigment::check_paint_name(ingredient.pigment);
        check_between(core::message("number of parts of %1", ingredient.pigment), "", ingredient.parts,
                      kLeastParts, kMostParts);
    }
    check_between(core::message("strength of the paint"), "", paint.strength, kLeastStrength, 1.0);
}

film::PaintCoefficients mixed_paint(const PaintRecipe& paint, const film::Medium& medium) {
    if (paint.ingredients.empty()) return film::paint_coefficients({}, medium);
    std::vector<pigment::Portion> portions;
    portions.reserve(paint.ingredients.size());
    for (const Ingredient& ingredient : paint.ingredients) {
        portions.push_back({pigment::named_paint(ingredient.pigment), ingredient.parts});
    }
    pigment::Coefficients coefficients = pigment::mix(portions);
    for (float& value : coefficients)
        value *= static_cast<float>(paint.strength);
    return film::paint_coefficients(coefficients, medium);
}

}  // namespace pastoso::document
