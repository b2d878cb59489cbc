#include "film/random_paint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

class Dice {
  public:
    explicit Dice(std::uint32_t seed) : random_(seed) {}
    double uniform() { return std::uniform_real_distribution<double>()(random_); }
    double between(double low, double high) { return low + (high - low) * uniform(); }
    /// Even over the decades.
    double decades(double low, double high) { return low * std::pow(high / low, uniform()); }
    bool coin() { return uniform() < 0.5; }
    Edge edge() { return static_cast<Edge>(static_cast<int>(3 * uniform())); }

  private:
    std::mt19937 random_;
};

/// White noise that does not depend on the order it is asked in.
double noise(std::uint32_t seed, int x, int y) {
    std::uint64_t bits =
        (static_cast<std::uint64_t>(seed) << 32) ^ static_cast<std::uint64_t>(x * 65537 + y);
    for (int round = 0; round < 2; ++round) {
        bits = (bits ^ (bits >> 31)) * 0x9e3779b97f4a7c15ULL;
        bits ^= bits >> 29;
    }
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

void choose_edges(EdgeKind kind, Dice& dice, Scene& scene) {
    const Edge same = kind == EdgeKind::Wall   ? Edge::Wall
                      : kind == EdgeKind::Open ? Edge::Open
                                               : Edge::Periodic;
    scene.edge_x = kind == EdgeKind::Mixed ? dice.edge() : same;
    scene.edge_y = kind == EdgeKind::Mixed ? dice.edge() : same;
}

/// The tilt. Two limits keep paint from filling cells, which full_cell_test.cpp is about: on walls, a
/// film as wide as a canvas rises to extent * F/g; and a film that falls faster than its own waves
/// (Froude number above 1) breaks into roll waves that climb onto each other without end.
void choose_force(double thickness, Dice& dice, Scene& scene) {
    const double wave_speed = std::sqrt(scene.gravity * thickness);
    const double fastest_fall = scene.gravity * thickness * thickness / (3 * scene.viscosity);
    const double largest = scene.gravity * std::min(1.0, wave_speed / fastest_fall);
    scene.force_x = dice.between(-1, 1) * largest * (scene.edge_x == Edge::Wall ? 0.2 : 1.0);
    scene.force_y = dice.between(-1, 1) * largest * (scene.edge_y == Edge::Wall ? 0.2 : 1.0);
}

/// Lets paint thin under shear, and eases its force by what it thins at the shear of a film as fast as
/// its waves: the same limit as above.
void choose_thinning(double thickness, double flow_index, Scene& scene) {
    scene.flow_index = flow_index;
    const double shear = 3 * std::sqrt(scene.gravity / thickness);
    const double thinned = (2 * flow_index + 1) / (3 * flow_index) * std::pow(shear, flow_index - 1);
    scene.force_x *= std::min(1.0, thinned);
    scene.force_y *= std::min(1.0, thinned);
}

void choose_properties(double thickness, Dice& dice, Scene& scene) {
    scene.gravity = dice.decades(0.1, 20);
    scene.viscosity = dice.decades(1e-2, 100);
    scene.tension = dice.decades(0.1, 50);
    choose_force(thickness, dice, scene);
    if (dice.coin()) scene.yield = dice.decades(0.01, 3);
    if (dice.coin()) {
        scene.tan_advancing = dice.between(0.2, 1.2);
        scene.tan_receding = dice.uniform() * scene.tan_advancing;
    }
    if (dice.coin()) {
        scene.alpha_min = dice.between(0.5, 1);
        scene.alpha_max = dice.between(1, 1.5);
    }
    scene.slip_cells = dice.coin() ? 0.2 : 0.0;
    scene.full_curvature = dice.coin();
}

/// Neglecting momentum's own flow (and lateral viscosity) is for creeping paint: where it would fall by
/// more than a cell while drag brings it to its speed, that model has bores that grow without bound.
void choose_neglect(double thickness, Dice& dice, Scene& scene) {
    const double drag_rate = 3 * scene.viscosity / (thickness * thickness);
    const double force = std::hypot(scene.force_x, scene.force_y) + scene.gravity;
    const bool creeps = force < drag_rate * drag_rate;
    scene.inertia = dice.coin() || !creeps;
    scene.lateral = dice.coin() || !creeps;
}

std::function<double(int, int)> random_support(Dice& dice, double thickness, std::uint32_t seed) {
    const double height = thickness * dice.between(0, 0.6), kind = dice.uniform();
    if (kind < 0.2) return [](int, int) { return 0.0; };
    if (kind < 0.5)
        return [=](int x, int y) { return height * (1 + std::sin(0.7 * x) * std::cos(0.5 * y)); };
    return [=](int x, int y) { return height * noise(seed + 1, x, y); };
}

/// Driven against a wall, paint gathers by nature: it comes to lie as a wedge of slope F/g, and may
/// swing to twice that height.
double wall_allowance(const Scene& scene) {
    double rise = 0;
    if (scene.edge_x == Edge::Wall) rise += std::abs(scene.force_x) * scene.width;
    if (scene.edge_y == Edge::Wall) rise += std::abs(scene.force_y) * scene.height;
    return 2 * rise / scene.gravity;
}

/// The thickest that paint may come to lie.
double thickness_allowance(const RandomPaint& paint) {
    return std::min(8 * paint.largest_mm + wall_allowance(paint.scene), kMaxThickness_mm);
}

void expect_sound(const Bench& bench, const RandomPaint& paint) {
    EXPECT_LE(bench.max_h(), thickness_allowance(paint));
    for (int y = 0; y < bench.setup.height; ++y)
        for (int x = 0; x < bench.setup.width; ++x) {
            ASSERT_GE(bench.state.thickness.at(x, y), 0) << x << ' ' << y;
            ASSERT_TRUE(std::isfinite(bench.u(x, y)) && std::isfinite(bench.v(x, y))) << x << ' ' << y;
            for (const std::int32_t channel : bench.state.paint.at(x, y))
                ASSERT_GE(channel, 0) << x << ' ' << y;
        }
}

void expect_nothing_lost(const Bench& bench, const Totals& before) {
    const Totals now = totals(bench.state);
    const Totals& runoff = bench.solver->runoff();
    EXPECT_EQ(now.thickness + runoff.thickness, before.thickness);
    for (std::size_t k = 0; k < before.paint.size(); ++k)
        EXPECT_EQ(now.paint[k] + runoff.paint[k], before.paint[k]) << "channel " << k;
}

void lay(const RandomPaint& paint, Bench& bench) {
    const std::uint32_t seed = paint.seed;
    bench.set_support(paint.support);
    bench.fill(paint.thickness);
    bench.tint(0, [seed](int x, int y) { return 200 * noise(seed + 2, x, y); });
    bench.tint(5, [](int x, int y) { return x < 20 && y > 10 ? 30.0 : 0.0; });
    bench.tint(11, [seed](int x, int y) { return 0.01 * noise(seed + 3, x, y); });
}

/// What a call of advance() passes. A large step must not carry paint by more than a fifth of a cell;
/// four of them are enough to show that they follow on each other.
double frame_s(const Scheme& scheme, const Bench& bench, const RandomPaint& paint) {
    const double limit_s = scheme.step_in_limits * bench.solver->stable_step_s(paint.largest_mm);
    if (scheme.options.scheme == film::Scheme::Explicit) return limit_s;
    const double drag_rate = 3 * paint.scene.viscosity / (paint.largest_mm * paint.largest_mm);
    const double speed = std::hypot(paint.scene.force_x, paint.scene.force_y) / drag_rate;
    return std::min(limit_s, 4 * 0.2 * paint.scene.cell_mm / speed);
}

void count_large_steps(const AdvanceReport& report, RandomRuns& runs) {
    runs.large_steps += report.large_steps;
    runs.rejected_steps += report.rejected_steps;
    runs.sweeps += report.sweeps;
    if (report.large_steps > 0) runs.cells += report.cells_stepped;
    runs.limited_cells += report.limited_cells;
}

void run_paint(const Scheme& scheme, RandomPaint paint, int steps, RandomRuns& runs) {
    SCOPED_TRACE(testing::Message() << "seed " << paint.seed);
    paint.scene.solver = scheme.options;
    Bench bench(paint.scene);
    lay(paint, bench);
    const Totals before = totals(bench.state);
    const double dt = frame_s(scheme, bench, paint);
    AdvanceReport early, late;
    for (int step = 0; step < 20; ++step)
        early.add(bench.solver->advance(dt));
    for (int step = 0; step < steps; ++step)
        late.add(bench.solver->advance(dt));
    expect_nothing_lost(bench, before);
    expect_sound(bench, paint);

    ++runs.paints;
    runs.paints_clamped_late += late.clamped_faces > 0 ? 1 : 0;
    runs.steps += early.steps + late.steps;
    runs.early_faces += 2 * early.cells_stepped;
    runs.early_clamps += early.clamped_faces;
    runs.late_faces += 2 * late.cells_stepped;
    runs.late_clamps += late.clamped_faces;
    count_large_steps(early, runs);
    count_large_steps(late, runs);
    runs.fullest = std::max(runs.fullest, bench.max_h() / thickness_allowance(paint));
}

}  // namespace

std::string name_of(EdgeKind edges) {
    switch (edges) {
        case EdgeKind::Periodic:
            return "Periodic";
        case EdgeKind::Wall:
            return "Wall";
        case EdgeKind::Open:
            return "Open";
        default:
            return "Mixed";
    }
}

std::vector<PaintCase> all_paint_cases() {
    std::vector<PaintCase> cases;
    for (const Scheme& scheme : all_schemes())
        for (const EdgeKind edges :
             {EdgeKind::Periodic, EdgeKind::Wall, EdgeKind::Open, EdgeKind::Mixed})
            cases.emplace_back(scheme, edges);
    return cases;
}

std::string name_of(const PaintCase& paint_case) {
    const auto& [scheme, edges] = paint_case;
    return scheme.name + name_of(edges);
}

RandomPaint random_paint(std::uint32_t seed, EdgeKind edges) {
    Dice dice(seed);
    RandomPaint paint;
    paint.seed = seed;
    paint.scene.width = dice.uniform() < 0.7 ? 40 : 70;
    paint.scene.height = dice.uniform() < 0.7 ? 40 : 67;
    choose_edges(edges, dice, paint.scene);
    const double thickness = dice.decades(0.2, 5);
    choose_properties(thickness, dice, paint.scene);
    paint.largest_mm = 2 * thickness;
    choose_neglect(paint.largest_mm, dice, paint.scene);
    if (noise(seed + 6, 0, 0) < 0.25)
        choose_thinning(paint.largest_mm, 0.4 + 0.6 * noise(seed + 6, 1, 0), paint.scene);
    paint.thickness = [seed, thickness](int x, int y) {
        return noise(seed + 4, x, y) < 0.3 ? 0.0 : 2 * thickness * noise(seed + 5, x, y);
    };
    paint.support = random_support(dice, thickness, seed);
    return paint;
}

RandomRuns run_random_paints(const Scheme& scheme, EdgeKind edges, const SeedRange& seeds) {
    RandomRuns runs;
    for (int i = 0; i < seeds.count; ++i)
        run_paint(scheme, random_paint(seeds.first_seed + static_cast<std::uint32_t>(i), edges),
                  seeds.steps, runs);
    return runs;
}

double per(std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

void expect_calm(const RandomRuns& runs) {
    std::printf(
        "%d paints, %lld steps: %lld of %lld faces clamped in the first 20 steps, %lld of %lld later, "
        "in "
        "%d paints\n",
        runs.paints, static_cast<long long>(runs.steps), static_cast<long long>(runs.early_clamps),
        static_cast<long long>(runs.early_faces), static_cast<long long>(runs.late_clamps),
        static_cast<long long>(runs.late_faces), runs.paints_clamped_late);
    std::printf(
        "%lld large steps: %.3f sweeps each, %.2e rejected, %.2e of their cells limited; %.2f of the "
        "thickest allowed\n",
        static_cast<long long>(runs.large_steps), per(runs.sweeps, runs.large_steps),
        per(runs.rejected_steps, runs.large_steps), per(runs.limited_cells, runs.cells), runs.fullest);
    EXPECT_LE(static_cast<double>(runs.early_clamps), 1e-4 * static_cast<double>(runs.early_faces));
    EXPECT_LE(static_cast<double>(runs.late_clamps), 1e-7 * static_cast<double>(runs.late_faces));
    EXPECT_LE(runs.paints_clamped_late, runs.paints / 20);
    EXPECT_LE(per(runs.sweeps, runs.large_steps), 4.0);
    // Where a contact line that stuck slips, a long step is taken again in parts.
    EXPECT_LE(per(runs.rejected_steps, runs.large_steps), 0.02);  // reached 1.5 %
    EXPECT_LE(per(runs.limited_cells, runs.cells), 1e-4);
}

}  // namespace pastoso::film::test
