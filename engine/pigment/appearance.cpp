#include "pigment/appearance.hpp"

#include "pigment/kubelka_munk.hpp"
#include "pigment/lab.hpp"
#include "pigment/palette.hpp"

#include <cmath>

namespace pastoso::pigment {
namespace {

const Coefficients& white_paint() {
    static const Coefficients white = find_pigment("PW6").coefficients;
    return white;
}

/// What leaves a film over a ground whose reflectance inside the binder is given per band.
Bands film_bands(const Coefficients& paint, double film_mm, const Bands& ground) {
    Bands reflectance{};
    for (int band = 0; band < kBands; ++band) {
        const double kh = paint[band] * film_mm;
        const double sh = paint[kBands + band] * film_mm;
        const double inside = layer_reflectance(kh, sh, static_cast<double>(ground[band]));
        reflectance[band] = static_cast<float>(through_surface(inside));
    }
    return reflectance;
}

double tint_difference(const Coefficients& paint, double white_parts) {
    return ciede2000(lab(tint(paint, white_parts)), lab(masstone(white_paint())));
}

LinearRgb times(const LinearRgb& colour, double factor) {
    LinearRgb scaled{};
    for (int i = 0; i < 3; ++i)
        scaled[i] = static_cast<float>(factor * colour[i]);
    return scaled;
}

}  // namespace

Bands opaque_bands(const Coefficients& paint) {
    Bands reflectance{};
    for (int band = 0; band < kBands; ++band)
        reflectance[band] = through_surface(opaque_reflectance(paint[band], paint[kBands + band]));
    return reflectance;
}

Bands titanium_ground() {
    Bands ground{};
    for (int band = 0; band < kBands; ++band)
        ground[band] = opaque_reflectance(white_paint()[band], white_paint()[kBands + band]);
    return ground;
}

LinearRgb masstone(const Coefficients& paint) {
    return linear_srgb(opaque_bands(paint));
}

LinearRgb undertone(const Coefficients& paint, double film_mm) {
    return linear_srgb(film_bands(paint, film_mm, titanium_ground()));
}

LinearRgb tint(const Coefficients& paint, double white_parts) {
    const std::array<Portion, 2> with_white = {{{paint, 1.0}, {white_paint(), white_parts}}};
    return masstone(mix(with_white));
}

double contrast_ratio(const Coefficients& paint, double film_mm) {
    const double over_black = relative_luminance(linear_srgb(film_bands(paint, film_mm, Bands{})));
    const double over_white = relative_luminance(undertone(paint, film_mm));
    return over_white > 0.0 ? over_black / over_white : 1.0;
}

double tinting_strength(const Coefficients& paint) {
    constexpr double kMostParts = 1e4;
    if (tint_difference(paint, 0.0) <= kPaleDifference) return 0.0;
    double coloured = std::log(1e-3), pale = std::log(kMostParts);
    if (tint_difference(paint, kMostParts) >= kPaleDifference) return kMostParts;
    for (int step = 0; step < 40; ++step) {
        const double middle = 0.5 * (coloured + pale);
        const bool is_pale = tint_difference(paint, std::exp(middle)) < kPaleDifference;
        (is_pale ? pale : coloured) = middle;
    }
    return std::exp(pale);
}

LinearRgb paint_colour(const LinearRgb& on_screen) {
    return times(on_screen, kPaintWhite);
}

LinearRgb screen_colour(const LinearRgb& of_paint) {
    return times(of_paint, 1.0 / kPaintWhite);
}

}  // namespace pastoso::pigment
