#include "document/paint_reading.hpp"

#include "pigment/paint_name.hpp"
#include "pigment/unmixing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pastoso::document {
namespace {

constexpr double kNoMixture = 0.05;

/// Below this, per mm, there is no pigment: a thousandth of the palest.
constexpr float kColourless_per_mm = 1e-4F;

constexpr double kPartsPerPercent = 10.0;
constexpr double kStrengthSteps = 100.0;

void note_names(const PaintRecipe& paint, std::vector<std::string>& names) {
    for (const Ingredient& part : paint.ingredients)
        if (std::find(names.begin(), names.end(), part.pigment) == names.end())
            names.push_back(part.pigment);
}

/// The decimal fraction that is nearest, `per_one` of its steps making 1.
double rounded(double value, double per_one) {
    return std::max(1.0, std::round(value * per_one)) / per_one;
}

}  // namespace

void note_paints(const Action& action, std::vector<std::string>& names) {
    if (const auto* load = std::get_if<LoadPaint>(&action)) {
        note_names(load->paint, names);
        note_names(load->second, names);
    } else if (const auto* squeeze = std::get_if<SqueezePaint>(&action)) {
        note_names(squeeze->paint, names);
    } else if (const auto* fill = std::get_if<FillWithPaint>(&action)) {
        note_names(fill->paint, names);
        note_names(fill->second, names);
    } else if (const auto* tone = std::get_if<ToneGround>(&action)) {
        note_names(tone->paint, names);
    } else if (const auto* texture = std::get_if<LayTexture>(&action)) {
        note_names(texture->paint, names);
    } else if (const auto* adjust = std::get_if<AdjustDryPaint>(&action)) {
        note_names(adjust->paint, names);
    }
}

std::optional<PaintRecipe> recipe_of(const pigment::Coefficients& mixture,
                                     std::span<const std::string> names, double pigment_share) {
    if (*std::max_element(mixture.begin(), mixture.end()) < kColourless_per_mm) return PaintRecipe{};
    std::vector<pigment::Coefficients> paints;
    for (const std::string& name : names)
        paints.push_back(pigment::named_paint(name));
    const pigment::Unmixed found = pigment::unmixed(mixture, paints);
    const double pigmented = std::accumulate(found.shares.begin(), found.shares.end(), 0.0);
    if (found.error > kNoMixture || pigmented <= 0.0) return std::nullopt;
    PaintRecipe recipe;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (found.shares[i] > 0.0)
            recipe.ingredients.push_back(
                {names[i], rounded(100.0 * found.shares[i] / pigmented, kPartsPerPercent)});
    std::stable_sort(recipe.ingredients.begin(), recipe.ingredients.end(),
                     [](const Ingredient& a, const Ingredient& b) { return a.parts > b.parts; });
    if (recipe.ingredients.size() == 1) recipe.ingredients.front().parts = 1.0;
    recipe.strength = std::min(1.0, rounded(pigmented / pigment_share, kStrengthSteps));
    return recipe;
}

}  // namespace pastoso::document
