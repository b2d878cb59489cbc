#include "tools/swatch.hpp"

#include "document/paint_mixing.hpp"
#include "film/medium.hpp"
#include "pigment/appearance.hpp"

#include <algorithm>
#include <optional>

namespace pastoso::tools {
namespace {

/// Nothing for paint that has no colour of its own.
std::optional<pigment::LinearRgb> masstone_of(const film::PaintCoefficients& paint) {
    constexpr float kColourless_per_mm = 1e-3F;
    pigment::Coefficients pigment{};
    std::copy_n(paint.begin(), pigment.size(), pigment.begin());
    if (*std::max_element(pigment.begin(), pigment.end()) < kColourless_per_mm) return std::nullopt;
    return pigment::masstone(pigment);
}

/// Its colour is the same in all.
film::PaintCoefficients in_some_medium(const document::PaintRecipe& paint) {
    return document::mixed_paint(paint, film::bundled_media().front());
}

}  // namespace

Swatch swatch(const pigment::Coefficients& paint) {
    constexpr double kWhitePerPaint = 4.0;
    return {pigment::encoded(pigment::masstone(paint)),
            pigment::encoded(pigment::tint(paint, kWhitePerPaint))};
}

pigment::Srgb8 paint_colour(const film::PaintCoefficients& paint) {
    const auto colour = masstone_of(paint);
    return colour ? pigment::encoded(*colour) : kClearMedium;
}

pigment::Srgb8 paint_colour(const document::PaintRecipe& paint) {
    return paint_colour(in_some_medium(paint));
}

pigment::Srgb8 screen_colour(const document::PaintRecipe& paint) {
    if (paint.ingredients.size() == 1) {
        const auto colour = pigment::parse_hex_colour(paint.ingredients.front().pigment);
        if (colour) return *colour;
    }
    const auto colour = masstone_of(in_some_medium(paint));
    return colour ? pigment::encoded(pigment::screen_colour(*colour)) : kClearMedium;
}

}  // namespace pastoso::tools
