#include "pigment/hiding.hpp"

#include "pigment/appearance.hpp"

namespace pastoso::pigment {

Hiding hiding_of(const Coefficients& paint, double film_mm) {
    constexpr double kSemiTransparent = 0.15, kSemiOpaque = 0.30, kOpaque = 0.35;
    const double ratio = contrast_ratio(paint, kDrawnOut * film_mm);
    if (ratio < kSemiTransparent) return Hiding::Transparent;
    if (ratio < kSemiOpaque) return Hiding::SemiTransparent;
    return ratio < kOpaque ? Hiding::SemiOpaque : Hiding::Opaque;
}

}  // namespace pastoso::pigment
