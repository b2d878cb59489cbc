#include "core/random.hpp"
#include "core/units.hpp"
#include "film/validation/bench.hpp"
#include "film/validation/flows.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

namespace pastoso::film::validation {
namespace {

constexpr double kForce = 9000.0, kViscosity = 300.0, kTension = 25000.0;
constexpr double kThickness_mm = 0.5, kSheet_mm = 40.0, kNoise_mm = 1.0;
constexpr double kWidth_mm = 180.0, kLength_mm = 76.0, kSeconds = 8.0;
constexpr int kModes = 40;

/// Where the paint ends in every row, mm: what lies in it, at the thickness of the sheet.
std::vector<double> front_of(const Bench& bench) {
    std::vector<double> front;
    for (int y = 0; y < bench.setup.height; ++y) {
        double last_mm = 0.0;
        for (int x = 0; x < bench.setup.width; ++x)
            if (bench.h(x, y) > 0.2 * kThickness_mm) last_mm = (x + 1) * bench.setup.cell_mm;
        front.push_back(last_mm);
    }
    return front;
}

/// Power of the front's waves, by how often they fit across; the mean wavelength by power.
double wavelength_mm(const std::vector<double>& front) {
    double power = 0.0, moment = 0.0;
    for (int mode = 2; mode <= kModes; ++mode) {
        std::complex<double> wave;
        for (std::size_t y = 0; y < front.size(); ++y)
            wave += std::polar(front[y], 2.0 * core::kPi * mode * static_cast<double>(y) /
                                             static_cast<double>(front.size()));
        power += std::norm(wave);
        moment += std::norm(wave) * mode;
    }
    return kWidth_mm * power / moment;
}

Outcome finger(const Run& run) {
    const int length = static_cast<int>(std::lround(kLength_mm / run.cell_mm));
    const int width = static_cast<int>(std::lround(kWidth_mm / run.cell_mm));
    Bench bench({.width = length,
                 .height = width,
                 .cell_mm = run.cell_mm,
                 .force_x = kForce,
                 .viscosity = kViscosity,
                 .tension = kTension,
                 .slip_cells = 0.2,
                 .edge_x = Edge::Wall,
                 .full_curvature = true,
                 .sleeping = true,
                 .solver = {.scheme = run.scheme},
                 .watch = run.watch});
    bench.fill([&](int x, int y) {
        // A millimetre of the canvas has one depth of the noise, whatever its cells.
        const auto place = static_cast<std::uint32_t>(y * run.cell_mm);
        const double edge_mm = kSheet_mm + kNoise_mm * core::uniform_noise(place, core::scramble(7));
        return kThickness_mm * std::clamp(edge_mm / run.cell_mm - x, 0.0, 1.0);
    });
    bench.pass(kSeconds);
    const std::vector<double> front = front_of(bench);
    Outcome outcome;
    const double mean_mm =
        std::accumulate(front.begin(), front.end(), 0.0) / static_cast<double>(front.size());
    for (std::size_t y = 0; y < front.size(); ++y)
        outcome.measured.push_back({(static_cast<double>(y) + 0.5) * run.cell_mm, front[y] - mean_mm});
    const double length_mm = std::cbrt(kTension * kThickness_mm / kForce);
    outcome.figures.push_back({"wavelength [l]", wavelength_mm(front) / length_mm, 14.0});
    return outcome;
}

}  // namespace

Case fingers() {
    return {.name = "fingers",
            .law = "a running front breaks into fingers 14 l apart, l = (sigma h / (rho F))^(1/3)",
            .source = "Troian, Herbolzheimer, Safran and Joanny, Europhys. Lett. 10 (1989)",
            .cells_mm = {0.5, 0.375, 0.25},
            .angles_deg = {0.0},
            .x_axis = "across [mm]",
            .y_axis = "front, ahead of its mean [mm]",
            .outcome = finger,
            .is_long = [](const Run&) { return true; }};
}

}  // namespace pastoso::film::validation
