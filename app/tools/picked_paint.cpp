#include "tools/picked_paint.hpp"

#include "document/number_text.hpp"
#include "document/paint_reading.hpp"

#include <cmath>

namespace pastoso::tools {
namespace {

constexpr double kRadius_mm = 0.5;

/// Whole percents, and tenths where a tenth matters.
std::string percent_text(double percent) {
    const double step = percent < 9.95 ? 10.0 : 1.0;
    return document::number_text(std::round(percent * step) / step) + " %";
}

}  // namespace

std::optional<PickedPaint> paint_at(const film::FilmState& film, std::span<const std::string> names,
                                    double x_mm, double y_mm) {
    const film::PaintSample sample = film::sample_paint(film, x_mm, y_mm, kRadius_mm);
    if (sample.layer == film::PaintLayer::Bare) return std::nullopt;
    const auto recipe = document::recipe_of(sample.coefficients, names);
    if (!recipe) return std::nullopt;
    return PickedPaint{*recipe, sample.layer};
}

std::string pigment_shares(const document::PaintRecipe& paint) {
    if (paint.ingredients.empty()) return "clear medium";
    double sum = 0.0;
    for (const document::Ingredient& part : paint.ingredients)
        sum += part.parts;
    std::string text;
    for (const document::Ingredient& part : paint.ingredients) {
        text += (text.empty() ? "" : ", ") + part.pigment;
        if (paint.ingredients.size() > 1) text += " " + percent_text(100.0 * part.parts / sum);
    }
    if (paint.strength < 1.0) text += ", thinned to " + percent_text(100.0 * paint.strength);
    return text;
}

}  // namespace pastoso::tools
