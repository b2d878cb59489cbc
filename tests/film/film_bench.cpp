#include "film/film_bench.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film::test {

double blob(double x, double y, double centre_x, double centre_y, double radius, double height) {
    const double r = std::hypot(x + 0.5 - centre_x, y + 0.5 - centre_y) / radius;
    return r < 1 ? height * (1 - r * r) : 0.0;
}

Scene runny(int width, int height) {
    return {.width = width,
            .height = height,
            .gravity = 1,
            .force_x = 0.3,
            .force_y = 0.5,
            .tension = 3,
            .alpha_min = 0.5,
            .alpha_max = 1.2,
            .tan_advancing = 0.5,
            .tan_receding = 0.2,
            .slip_cells = 0.2};
}

std::string name_of(Edge edge) {
    switch (edge) {
        case Edge::Periodic:
            return "Periodic";
        case Edge::Wall:
            return "Wall";
        default:
            return "Open";
    }
}

void Bench::tint(int channel, const std::function<double(int, int)>& per_mm) {
    for (int y = 0; y < setup.height; ++y)
        for (int x = 0; x < setup.width; ++x) {
            PaintCell cell = state.paint.at(x, y);
            cell[channel] =
                static_cast<std::int32_t>(std::lround(per_mm(x, y) * h(x, y) / kPaintQuantum));
            state.paint.set(x, y, cell);
        }
}

double Bench::largest_difference(const std::function<double(int, int)>& thickness) const {
    double largest = 0.0;
    for (int y = 0; y < setup.height; ++y)
        for (int x = 0; x < setup.width; ++x)
            largest = std::max(largest, std::abs(h(x, y) - thickness(x, y)));
    return largest;
}

void Bench::carry_consistency() {
    const Consistency consistency = consistency_of(validation::medium_of(setup));
    tint(kViscosityChannel, [&](int, int) { return consistency.log_viscosity; });
    tint(kYieldChannel, [&](int, int) { return consistency.yield_stress_Pa; });
    state.consistencies.add(consistency);
}

}  // namespace pastoso::film::test
