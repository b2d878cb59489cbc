#include "tools/swatch.hpp"

#include "pigment/appearance.hpp"

namespace pastoso::tools {

Swatch swatch(const pigment::Coefficients& paint) {
    constexpr double kWhitePerPaint = 4.0;
    return {pigment::encoded(pigment::masstone(paint)),
            pigment::encoded(pigment::tint(paint, kWhitePerPaint))};
}

}  // namespace pastoso::tools
