#include "film/air_jet.hpp"

#include "core/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

constexpr double kLeanShare = 2.0;

/// A place of the canvas as a jet sees it.
struct JetPlace {
    double x, y;  ///< from the middle, in radii
    bool is_reached;
    double falloff;  ///< e^(-(d/r)^2)
    double tilted;   ///< 1 - |lean| - 2 lean . (x - middle) / r
};

JetPlace place_in(const AirJet& jet, double x_mm, double y_mm) {
    const double x = (x_mm - jet.x_mm) / jet.radius_mm, y = (y_mm - jet.y_mm) / jet.radius_mm;
    const double distance2 = x * x + y * y;
    if (distance2 >= kJetReach_radii * kJetReach_radii) return {x, y, false, 0.0, 0.0};
    const double upright = 1.0 - std::hypot(jet.lean_x, jet.lean_y);
    return {x, y, true, core::exponential(-distance2),
            upright - kLeanShare * (jet.lean_x * x + jet.lean_y * y)};
}

}  // namespace

grid::Rect cells_reached(const AirJet& jet, grid::Shape canvas, double cell_mm) {
    const double reach_mm = kJetReach_radii * jet.radius_mm;
    const auto cell = [&](double mm, int extent) {
        return static_cast<int>(std::clamp(std::floor(mm / cell_mm), 0.0, static_cast<double>(extent)));
    };
    return {cell(jet.x_mm - reach_mm, canvas.width), cell(jet.y_mm - reach_mm, canvas.height),
            cell(jet.x_mm + reach_mm + cell_mm, canvas.width),
            cell(jet.y_mm + reach_mm + cell_mm, canvas.height)};
}

double air_pressure_Pa(const AirJet& jet, double x_mm, double y_mm) {
    const JetPlace place = place_in(jet, x_mm, y_mm);
    return place.is_reached ? jet.pressure_Pa * place.falloff * place.tilted : 0.0;
}

double air_push_mm_s2(const AirJet& jet, double density_kg_m3, double x_mm, double y_mm) {
    const JetPlace place = place_in(jet, x_mm, y_mm);
    if (!place.is_reached) return 0.0;
    const double slope_x = -2.0 * place.x * place.tilted - kLeanShare * jet.lean_x;
    const double slope_y = -2.0 * place.y * place.tilted - kLeanShare * jet.lean_y;
    return jet.pressure_Pa / density_kg_m3 * kPaPerDensity_mm2_s2 / jet.radius_mm * place.falloff *
           std::hypot(slope_x, slope_y);
}

}  // namespace pastoso::film
