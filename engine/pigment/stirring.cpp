#include "pigment/stirring.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::pigment {

OpticalThickness optical_thickness(const LayerOptics<double>& layer) {
    constexpr double kLeastReflected = 1e-4, kLeastAbsorbed = 1e-6;
    const double r = std::clamp(layer.reflectance, kLeastReflected, 1.0 - kLeastThrough);
    const double t = std::clamp(layer.transmittance, kLeastThrough, 1.0 - r);
    const double a = std::max(1.0, (1.0 + r * r - t * t) / (2.0 * r));
    const double b = std::sqrt(a * a - 1.0);
    const double sh = b > kLeastAbsorbed ? std::asinh(b * r / t) / b : r / t;
    return {(a - 1.0) * sh, sh};
}

LayerOptics<double> stirred(const LayerOptics<double>& layer, const OpticalThickness& other,
                            double share) {
    const auto [kh, sh] = optical_thickness(layer);
    const auto mean = [share](double a, double b) { return (1.0 - share) * a + share * b; };
    const LayerOptics<double> all = layer_optics(other.kh, other.sh);
    const LayerOptics<double> flecks = flecked(layer, all, share);
    const LayerOptics<double> mixed = layer_optics(mean(kh, other.kh), mean(sh, other.sh));
    const LayerOptics<double> unmixed = flecked(layer_optics(kh, sh), all, share);
    const auto shifted = [](double value, double to, double from) {
        return std::clamp(value + to - from, 0.0, 1.0);
    };
    return {shifted(flecks.reflectance, mixed.reflectance, unmixed.reflectance),
            shifted(flecks.transmittance, mixed.transmittance, unmixed.transmittance),
            shifted(flecks.reverse, mixed.reverse, unmixed.reverse)};
}

}  // namespace pastoso::pigment
