#include "pigment/rgb_paint.hpp"

#include "pigment/appearance.hpp"
#include "pigment/kubelka_munk.hpp"
#include "pigment/lab.hpp"
#include "pigment/smooth_bands.hpp"

#include <algorithm>

namespace pastoso::pigment {

Coefficients paint_of_bands(const Bands& reflectance, double opacity) {
    constexpr double kScattering_per_mm = 60.0;
    constexpr double kPassed = (1.0 - kExternalReflection) * (1.0 - kInternalReflection);
    Coefficients paint{};
    for (int band = 0; band < kBands; ++band) {
        const double outside = reflectance[band];
        const double inside = outside / (kPassed + kInternalReflection * outside);
        const double ratio = (1.0 - inside) * (1.0 - inside) / (2.0 * inside);
        const double scattering = std::min(kScattering_per_mm * opacity * (0.2 + 0.8 * inside),
                                           kStrongestAbsorption_per_mm / ratio);
        paint[band] = static_cast<float>(ratio * scattering);
        paint[kBands + band] = static_cast<float>(scattering);
    }
    return paint;
}

RgbPaint rgb_paint(const LinearRgb& on_screen, double opacity) {
    const LinearRgb wanted = paint_colour(on_screen);
    RgbPaint paint;
    paint.coefficients = paint_of_bands(smooth_bands(wanted).reflectance, opacity);
    paint.difference = ciede2000(lab(masstone(paint.coefficients)), lab(wanted));
    return paint;
}

}  // namespace pastoso::pigment
