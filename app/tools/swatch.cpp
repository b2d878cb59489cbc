#include "tools/swatch.hpp"

#include "brush/laid_film.hpp"
#include "document/actions/actions.hpp"
#include "document/paint_mixing.hpp"
#include "pigment/appearance.hpp"
#include "tools/mixed_paints.hpp"

#include <algorithm>
#include <numeric>

namespace pastoso::tools {
namespace {

/// A brush that holds less of its capacity leaves hardly a trace.
constexpr double kSpent = 0.02;

/// One that holds less lays a film with gaps.
constexpr double kGapless = 0.3;

/// Nothing for paint that has no colour of its own.
std::optional<pigment::LinearRgb> masstone_of(const film::PaintCoefficients& paint) {
    constexpr float kColourless_per_mm = 1e-3F;
    pigment::Coefficients pigment{};
    std::copy_n(paint.begin(), pigment.size(), pigment.begin());
    if (*std::max_element(pigment.begin(), pigment.end()) < kColourless_per_mm) return std::nullopt;
    return pigment::masstone(pigment);
}

double hidden_share(const film::PaintCoefficients& paint, shade::Spot spot) {
    const auto brightness = [&](const pigment::Bands& ground) {
        spot.ground = ground;
        const pigment::Srgb8 colour = shade::spot_colour(paint, spot);
        return std::accumulate(colour.begin(), colour.end(), 0.0) / (255.0 * colour.size());
    };
    return 1.0 - (brightness(pigment::titanium_ground()) - brightness({}));
}

/// Thick, its colour is the same in all.
film::PaintCoefficients in_some_medium(const document::PaintRecipe& paint) {
    return document::mixed_paint(paint, film::bundled_media().front());
}

}  // namespace

double film_in_hand_mm(const Hand& hand) {
    const brush::Preset tool = preset_in_hand(hand);
    const double laid_mm = tool.dips ? brush::laid_film_mm(tool, hand.dip.fill) : 0.0;
    return laid_mm > 0.0 ? laid_mm : document::medium_of(hand.medium).typical_thickness_mm;
}

pigment::Srgb8 swatch_colour(const film::PaintCoefficients& paint, const SwatchView& view) {
    return shade::spot_colour(paint, view.spot);
}

pigment::Srgb8 swatch_colour(const document::PaintRecipe& paint, const SwatchView& view) {
    return swatch_colour(remembered_paint(paint, view.medium), view);
}

WetColour wet_colour(const film::PaintCoefficients& paint, const SwatchView& view) {
    return {swatch_colour(paint, view), hidden_share(paint, view.spot)};
}

WetColour wet_colour(const document::PaintRecipe& paint, const SwatchView& view) {
    return wet_colour(remembered_paint(paint, view.medium), view);
}

std::optional<WetColour> wet_colour(const brush::LoadProfile& load, const SwatchView& view) {
    film::PaintCoefficients mean{};
    double fill = 0.0;
    for (const auto& stripe : load.stripes) {
        fill += stripe.fill;
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += static_cast<float>(stripe.fill) * stripe.paint[i];
    }
    if (load.fill < kSpent) return std::nullopt;
    for (float& coefficient : mean)
        coefficient /= static_cast<float>(fill);
    WetColour colour = wet_colour(mean, view);
    colour.opacity *= std::min(1.0, load.fill / kGapless);
    return colour;
}

document::PaintRecipe tube_paint(const std::string& ci_name) {
    document::PaintRecipe paint;
    if (!ci_name.empty()) paint.ingredients = {{ci_name, 1.0}};
    return paint;
}

document::PaintRecipe tube_tint(const std::string& ci_name) {
    constexpr double kWhiteParts = 4.0;
    if (ci_name.empty()) return {{{"PW6", 1.0}}, kWhiteParts / (kWhiteParts + 1.0)};
    return {{{ci_name, 1.0}, {"PW6", kWhiteParts}}, 1.0};
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
