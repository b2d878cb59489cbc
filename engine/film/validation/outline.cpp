#include "film/validation/outline.hpp"

#include "core/units.hpp"

#include <cmath>

namespace pastoso::film::validation {
namespace {

constexpr int kSamples = 8;
constexpr double kStep_cells = 0.01;

/// h between the centres of four cells.
double interpolated(const Bench& bench, double x_cells, double y_cells) {
    const double left = std::floor(x_cells - 0.5), top = std::floor(y_cells - 0.5);
    const double across = x_cells - 0.5 - left, down = y_cells - 0.5 - top;
    const int x = static_cast<int>(left), y = static_cast<int>(top);
    return (1 - down) * ((1 - across) * bench.h(x, y) + across * bench.h(x + 1, y)) +
           down * ((1 - across) * bench.h(x, y + 1) + across * bench.h(x + 1, y + 1));
}

}  // namespace

void fill_round(Bench& bench, const std::function<double(double)>& thickness_mm) {
    const double middle_x = 0.5 * bench.setup.width, middle_y = 0.5 * bench.setup.height;
    bench.fill([&](int x, int y) {
        double sum = 0.0;
        for (int sample = 0; sample < kSamples * kSamples; ++sample) {
            const double at_x = x + (sample % kSamples + 0.5) / kSamples - middle_x;
            const double at_y = y + (sample / kSamples + 0.5) / kSamples - middle_y;
            sum += thickness_mm(std::hypot(at_x, at_y) * bench.setup.cell_mm);
        }
        return sum / (kSamples * kSamples);
    });
}

double radius_towards(const Bench& bench, double angle_deg, double h_mm) {
    const double middle = 0.5 * bench.setup.width;
    const double cosine = std::cos(core::radians(angle_deg)), sine = std::sin(core::radians(angle_deg));
    double r = 0.0;
    while (r < middle - 2.0 && interpolated(bench, middle + r * cosine, middle + r * sine) > h_mm)
        r += kStep_cells;
    return r * bench.setup.cell_mm;
}

Curve radial_profile(const Bench& bench) {
    const double middle = 0.5 * bench.setup.width;
    Curve profile;
    for (double r = 0.0; r < middle - 2.0; r += 0.25)
        profile.push_back({r * bench.setup.cell_mm, interpolated(bench, middle + r, middle)});
    return profile;
}

}  // namespace pastoso::film::validation
