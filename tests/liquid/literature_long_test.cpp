// The tea's flow against what others measured and derived.
#include "core/random.hpp"
#include "liquid/tea/milk_tea.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr double kPi = std::numbers::pi;

/// Milk that is heavy and stays so: it neither warms nor dissolves.
TeaSettings lasting_milk() {
    TeaSettings settings;
    settings.fat_m_s2 = 0.0;
    settings.slow_warming_s = 1e6;
    settings.dissolving_at_rest_s = 1e9;
    settings.rest_ends_s = 1e9;
    settings.first_ball_s = 1e6;
    return settings;
}

/// The depth under the level that a fiftieth of a cubic centimetre of milk has passed, in metres.
double front_m(const MilkTea& tea) {
    constexpr double kAhead_m3 = 2e-8;
    std::vector<float> heights;
    for (const Parcel& parcel : tea.parcels())
        heights.push_back(parcel.position_m.z);
    const auto ahead = static_cast<std::size_t>(kAhead_m3 / tea.settings().milk_m3 *
                                                static_cast<double>(tea.settings().parcels));
    if (heights.size() <= ahead) return 0.0;
    const auto deep = heights.begin() + static_cast<std::ptrdiff_t>(ahead);
    std::nth_element(heights.begin(), deep, heights.end());
    return static_cast<double>(tea.settings().cup.level_m - *deep);
}

/// Least squares.
double slope_of_line_through(const std::vector<double>& x, const std::vector<double>& y) {
    const double n = static_cast<double>(x.size());
    const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n,
                 mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    return xy / xx;
}

/// A thin stream of heavy milk into a wide glass, as a plume has it from the first: for a speed w,
/// 5 g' r / (8 alpha w^2) is 1 with an entrainment alpha of 0.1 (B. R. Morton, J. Fluid Mech. 5, 1959).
TeaSettings starting_plume() {
    TeaSettings settings = lasting_milk();
    settings.cup = {.axis_m = {0.1F, 0.1F},
                    .floor_m = 0.004F,
                    .floor_radius_m = 0.095F,
                    .slope = 0.0F,
                    .level_m = 0.196F,
                    .wall_m = 0.002F,
                    .foot_m = -0.0015F,
                    .rim_m = 0.2F};
    settings.box_m = 0.2;
    settings.cells = 96;
    settings.advection = VelocityAdvection::Reflected;
    settings.parcels = 100'000;
    settings.cold_m_s2 = 0.6;
    settings.viscosity_m2_s = 1e-6;
    settings.pour_radius_m = 0.003;
    settings.pour_speed_m_s = 0.106;
    settings.pour_height_m = 0.0;
    settings.pour_s = 4.0;
    settings.milk_m3 = kPi * settings.pour_radius_m * settings.pour_radius_m * settings.pour_speed_m_s *
                       settings.pour_s;
    return settings;
}

/// From 10 to 25 diameters, of a stream that a hand holds not quite still: it must become turbulent, as
/// those of the experiments were.
double exponent_of_starting_plume(std::uint32_t seed, core::ThreadPool& pool) {
    const TeaSettings settings = starting_plume();
    MilkTea tea(settings);
    tea.pour_recipe(false);
    auto aside_m = [&, lot = 0U]() mutable {
        const float shake_m = 0.5F * static_cast<float>(settings.pour_radius_m);
        return shake_m * (2.0F * core::uniform_noise(lot++, seed) - 1.0F);
    };
    const double diameter_m = 2.0 * settings.pour_radius_m;
    std::vector<double> times, depths;
    for (double depth_m = 0.0; depth_m < 25.0 * diameter_m && tea.time_s() < settings.pour_s;) {
        const float x_m = aside_m(), y_m = aside_m();
        tea.pour_by_hand(settings.cup.axis_m + glm::vec2(x_m, y_m));
        tea.step(pool);
        depth_m = front_m(tea);
        if (depth_m < 10.0 * diameter_m) continue;
        times.push_back(std::log(tea.time_s()));
        depths.push_back(std::log(depth_m));
    }
    EXPECT_GT(times.size(), 20U);
    return slope_of_line_through(times, depths);
}

/// J. S. Turner, J. Fluid Mech. 13, 1962; Diez, Sangras, Faeth and Kwon, J. Heat Transfer 125, 2003:
/// where the flux of buoyancy is constant, the front goes as t^(3/4). Each run has whirls of its own.
TEST(StartingPlume, GoesDownAsTurnerFound) {
    core::ThreadPool pool;
    double sum = 0.0;
    constexpr int kRuns = 9;
    for (int run = 0; run < kRuns; ++run) {
        const double exponent = exponent_of_starting_plume(static_cast<std::uint32_t>(run) + 1, pool);
        RecordProperty("exponent_" + std::to_string(run), std::to_string(exponent));
        sum += exponent;
    }
    EXPECT_NEAR(sum / kRuns, 0.75, 0.1);
}

TEST(StartingPlume, OfTheRecipeIsThatOfFinerCells) {
    core::ThreadPool pool;
    TeaSettings settings;
    settings.parcels = 100'000;
    MilkTea coarse(settings);
    settings.cells = 128;
    MilkTea fine(settings);
    while (coarse.time_s() < 0.8) {
        coarse.step(pool);
        fine.step(pool);
        if (coarse.time_s() < 0.2) continue;
        EXPECT_NEAR(front_m(coarse), front_m(fine), 0.1 * front_m(fine)) << coarse.time_s() << " s";
    }
}

TEST(MilkTea, KeepsItsMilkFor45Seconds) {
    core::ThreadPool pool;
    TeaSettings settings;
    settings.parcels = 50'000;
    MilkTea tea(settings);
    while (tea.time_s() < 45.0) {
        tea.step(pool);
        if (tea.steps() % 30 == 0) {
            ASSERT_NEAR(tea.milk_m3(pool) / tea.poured_m3(), 1.0, 1e-6) << tea.time_s() << " s";
        }
    }
}

// Rayleigh-Taylor: a layer of heavy milk over tea.

constexpr double kGravity_m_s2 = 0.6;  ///< of milk against tea

/// How fast waves of wavenumber k (1/m) grow between two deep layers of the same viscosity whose density
/// differs little: n^2 = (g'/2) k (1 - k / q), q^2 = k^2 + n / nu (S. Chandrasekhar, Hydrodynamic and
/// Hydromagnetic Stability, 1961, chapter X).
double growth_per_s(double k, double viscosity_m2_s) {
    double low = 0.0, high = std::sqrt(0.5 * kGravity_m_s2 * k);
    for (int halving = 0; halving < 60; ++halving) {
        const double n = 0.5 * (low + high), q = std::sqrt(k * k + n / viscosity_m2_s);
        (n * n < 0.5 * kGravity_m_s2 * k * (1.0 - k / q) ? low : high) = n;
    }
    return low;
}

double fastest_wavelength_m(double viscosity_m2_s) {
    double best_m = 0.0, fastest = 0.0;
    for (double length_m = 0.002; length_m < 0.08; length_m *= 1.005) {
        const double growth = growth_per_s(2.0 * kPi / length_m, viscosity_m2_s);
        if (growth > fastest) fastest = growth, best_m = length_m;
    }
    return best_m;
}

constexpr int kSide_cells = 96, kLayer_cells = 20;
constexpr float kCell_m = 0.001F, kStep_s = 0.01F;

/// A layer of milk over one of tea in a square box, the milk's underside displaced by white noise.
class Layers {
  public:
    Layers(double viscosity_m2_s, std::uint32_t seed)
        : flow_({kSide_cells, kSide_cells, 2 * kLayer_cells, kCell_m},
                [](const glm::vec3&) { return -1.0F; },
                {.viscosity_m2_s = static_cast<float>(viscosity_m2_s), .pressure = {1e-4F, 50}}),
          milk_(flow_.shape()),
          none_(flow_.shape()),
          sorter_(flow_.shape()) {
        constexpr int kEach = 2;  // parcels along a cell
        constexpr float kApart_m = kCell_m / kEach, kNoise_m = 1e-4F * kCell_m;
        constexpr int kRow = kEach * kSide_cells;
        for (int x = 0; x < kRow; ++x)
            for (int y = 0; y < kRow; ++y) {
                const auto lot = core::uniform_noise(static_cast<std::uint32_t>(y * kRow + x), seed);
                for (int z = 0; z < kEach * kLayer_cells; ++z)
                    parcels_.push_back(
                        {{(static_cast<float>(x) + 0.5F) * kApart_m,
                          (static_cast<float>(y) + 0.5F) * kApart_m,
                          kLayer_cells * kCell_m + (static_cast<float>(z) + 0.5F) * kApart_m +
                              kNoise_m * (lot - 0.5F)},
                         kApart_m * kApart_m * kApart_m});
            }
    }

    void step(core::ThreadPool& pool) {
        sorter_.sort(parcels_, pool);
        std::ranges::fill(milk_.values(), 0.0F);
        const auto share = static_cast<float>(1.0 / flow_.shape().cell_volume_m3());
        share_out_sorted(parcels_, flow_.walls().open_cells(), {&milk_, &none_, &none_, &none_}, pool,
                         [&](const Parcel& parcel) {
                             return SharedAmounts{share * parcel.volume_m3, 0.0F, 0.0F, 0.0F};
                         });
        const float push = 0.5F * kStep_s * static_cast<float>(kGravity_m_s2);
        grid::BoxField& w = flow_.velocity().z;
        for (int k = 1; k < 2 * kLayer_cells; ++k)
            for (int j = 0; j < kSide_cells; ++j)
                for (int i = 0; i < kSide_cells; ++i)
                    w.at(i, j, k) -= push * (milk_.at(i, j, k) + milk_.at(i, j, k - 1));
        flow_.diffuse_velocity(kStep_s, pool);
        flow_.project(pool);
        places_m_.resize(parcels_.size());
        std::ranges::transform(parcels_, places_m_.begin(), &Parcel::position_m);
        flow_.carry(places_m_, kStep_s, pool);
        for (std::size_t i = 0; i < parcels_.size(); ++i)
            parcels_[i].position_m = places_m_[i];
        flow_.advect_velocity(kStep_s, pool);
    }

    /// |w|^2 at the milk's underside, of a wave of m and n half lengths along the box' sides.
    double power(int m, int n) const {
        double sum = 0.0;
        for (int j = 0; j < kSide_cells; ++j)
            for (int i = 0; i < kSide_cells; ++i)
                sum += static_cast<double>(flow_.velocity().z.at(i, j, kLayer_cells)) *
                       std::cos(kPi * m * (i + 0.5) / kSide_cells) *
                       std::cos(kPi * n * (j + 0.5) / kSide_cells);
        return sum * sum;
    }

    double fastest_m_s() const {
        const std::vector<float>& w = flow_.velocity().z.values();
        return static_cast<double>(
            std::abs(*std::ranges::max_element(w, {}, [](float value) { return std::abs(value); })));
    }

  private:
    VesselFlow flow_;
    grid::BoxField milk_, none_;
    std::vector<Parcel> parcels_;
    std::vector<glm::vec3> places_m_;
    ParcelSorter sorter_;
};

/// Where a parabola through the logarithms of all waves' powers has its top, in cells. Single waves have
/// an exponential distribution around the mean; some hundred are enough.
double strongest_wavelength_cells(const Layers& layers, double shortest_cells, double longest_cells) {
    std::array<double, 5> sums{};   // of x^n
    std::array<double, 3> right{};  // of x^n y
    const int most = static_cast<int>(2.0 * kSide_cells / shortest_cells) + 1;
    for (int m = 0; m < most; ++m)
        for (int n = 0; n < most; ++n) {
            const double length_cells = 2.0 * kSide_cells / std::hypot(m, n);
            if (!(length_cells >= shortest_cells && length_cells <= longest_cells)) continue;
            const double x = std::log(length_cells), y = std::log(layers.power(m, n));
            for (int power = 0; power < 5; ++power)
                sums[static_cast<std::size_t>(power)] += std::pow(x, power);
            for (int power = 0; power < 3; ++power)
                right[static_cast<std::size_t>(power)] += std::pow(x, power) * y;
        }
    const glm::dmat3 normal(sums[0], sums[1], sums[2], sums[1], sums[2], sums[3], sums[2], sums[3],
                            sums[4]);
    const glm::dvec3 fit = glm::inverse(normal) * glm::dvec3(right[0], right[1], right[2]);
    EXPECT_LT(fit.z, 0.0);
    return std::exp(-0.5 * fit.y / fit.z);
}

TEST(RayleighTaylor, FingersAreAsWideAsChandrasekharSays) {
    // The fastest wave has 20 cells: see decision 0063 for shorter ones.
    constexpr double kViscosity_m2_s = 3.7e-5, kFoldings = 8.0;
    const double expected_m = fastest_wavelength_m(kViscosity_m2_s),
                 growth = growth_per_s(2.0 * kPi / expected_m, kViscosity_m2_s);
    const double expected_cells = expected_m / static_cast<double>(kCell_m);
    core::ThreadPool pool;
    Layers layers(kViscosity_m2_s, 5);
    for (int step = 0; step * static_cast<double>(kStep_s) * growth < kFoldings; ++step)
        layers.step(pool);
    const double found = strongest_wavelength_cells(layers, 0.5 * expected_cells, 2.0 * expected_cells);
    RecordProperty("wavelength_cells", std::to_string(found));
    EXPECT_NEAR(found, expected_cells, 0.3 * expected_cells);
    // Still linear: the largest wave, w over its growth, is low beside a cell.
    EXPECT_LT(layers.fastest_m_s() / growth, 0.3 * static_cast<double>(kCell_m));
}

}  // namespace
}  // namespace pastoso::liquid
