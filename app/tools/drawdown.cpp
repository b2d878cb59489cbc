#include "tools/drawdown.hpp"

#include "pigment/appearance.hpp"
#include "tools/mixed_paints.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::tools {
namespace {

pigment::Hiding hiding_of(const film::PaintCoefficients& paint, double film_mm) {
    pigment::Coefficients optics{};
    std::copy_n(paint.begin(), optics.size(), optics.begin());
    return pigment::hiding_of(optics, film_mm);
}

}  // namespace

Drawdown drawdown(const document::PaintRecipe& paint, const SwatchView& view) {
    const film::PaintCoefficients& mixed = remembered_paint(paint, view.medium);
    Drawdown drawn;
    drawn.hiding = hiding_of(mixed, view.spot.film_mm);
    shade::Spot over_white = view.spot, over_black = view.spot;
    over_white.ground = pigment::titanium_ground();
    over_black.ground = {};
    for (int step = 0; step < Drawdown::kSteps; ++step) {
        const double share = std::pow(pigment::kDrawnOut, step / (Drawdown::kSteps - 1.0));
        over_white.film_mm = over_black.film_mm = share * view.spot.film_mm;
        drawn.over_white[step] = shade::spot_colour(mixed, over_white);
        drawn.over_black[step] = shade::spot_colour(mixed, over_black);
    }
    return drawn;
}

pigment::Hiding hiding_of(const document::PaintRecipe& paint, const SwatchView& view) {
    return hiding_of(remembered_paint(paint, view.medium), view.spot.film_mm);
}

}  // namespace pastoso::tools
