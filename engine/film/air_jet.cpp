#include "film/air_jet.hpp"

#include "core/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

constexpr double kLeanShare = 2.0;

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
    const double x = (x_mm - jet.x_mm) / jet.radius_mm, y = (y_mm - jet.y_mm) / jet.radius_mm;
    const double distance2 = x * x + y * y;
    if (distance2 >= kJetReach_radii * kJetReach_radii) return 0.0;
    const double upright = 1.0 - std::hypot(jet.lean_x, jet.lean_y);
    const double along = kLeanShare * (jet.lean_x * x + jet.lean_y * y);
    return jet.pressure_Pa * core::exponential(-distance2) * (upright - along);
}

double strongest_push_mm_s2(const AirJet& jet, double density_kg_m3) {
    const double lean = std::hypot(jet.lean_x, jet.lean_y);
    const double steepest_per_mm = (0.86 * (1.0 - lean) + kLeanShare * lean) / jet.radius_mm;
    return jet.pressure_Pa / density_kg_m3 * kPaPerDensity_mm2_s2 * steepest_per_mm;
}

}  // namespace pastoso::film
