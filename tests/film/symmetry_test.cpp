// The grid has no preferred direction: a canvas mirrored, turned or transposed, forces with it, gives
// the same film mirrored, turned or transposed, to the last bit of thickness, velocity and pigment. All
// sums in the kernels pair what a mirror exchanges, so no tolerance is needed.
#include "film/film_bench.hpp"
#include "film/schemes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr int kSide = 76;  // four tiles, unequal ones: a mirror moves their seams

/// One of the eight ways to lay a square on itself: first mirrored, then transposed.
struct Turn {
    const char* name;
    bool mirror_x, mirror_y, transpose;

    /// The cell of the straight canvas that lies at (x, y) of the turned one.
    std::pair<int, int> cell(int x, int y) const {
        if (transpose) std::swap(x, y);
        return {mirror_x ? kSide - 1 - x : x, mirror_y ? kSide - 1 - y : y};
    }
    Scene scene(Scene straight) const {
        if (mirror_x) straight.force_x = -straight.force_x;
        if (mirror_y) straight.force_y = -straight.force_y;
        if (transpose) {
            std::swap(straight.force_x, straight.force_y);
            std::swap(straight.edge_x, straight.edge_y);
        }
        return straight;
    }
};

const std::vector<Turn> kTurns = {
    {"MirroredX", true, false, false},   {"MirroredY", false, true, false},
    {"Turned180", true, true, false},    {"Transposed", false, false, true},
    {"Turned90", false, true, true},     {"Turned270", true, false, true},
    {"AntiTransposed", true, true, true}};

struct Paint {
    const char* name;
    Scene scene;
};

std::vector<Paint> paints() {
    const Scene newtonian{.width = kSide,
                          .height = kSide,
                          .gravity = 1,
                          .force_x = 0.4,
                          .force_y = -0.25,
                          .tension = 3,
                          .edge_x = Edge::Open,
                          .edge_y = Edge::Wall};
    Scene rich = newtonian;
    rich.yield = 0.05;
    rich.alpha_min = 0.5;
    rich.alpha_max = 1.2;
    rich.tan_advancing = 0.5;
    rich.tan_receding = 0.2;
    rich.slip_cells = 0.2;
    rich.full_curvature = true;
    rich.edge_x = Edge::Periodic;
    rich.edge_y = Edge::Open;
    Scene creeping = newtonian;
    creeping.viscosity = 20;
    creeping.inertia = creeping.lateral = false;
    creeping.edge_x = creeping.edge_y = Edge::Periodic;
    return {{"Newtonian", newtonian}, {"Rich", rich}, {"Creeping", creeping}};
}

/// Rough paint with dry cells, on a rough support; the same values wherever it is asked for.
double noise(int x, int y, unsigned salt) {
    std::minstd_rand random(static_cast<unsigned>(x * 977 + y) * 131U + salt);
    random.discard(3);
    return std::uniform_real_distribution<double>()(random);
}
double thickness(int x, int y) {
    const double r = std::hypot(x - 30.2, y - 41.7) / 24;
    const double blob = r < 1 ? 3 * (1 - r * r) : 0.0;
    return blob + (noise(x, y, 1) < 0.5 ? 0.0 : 0.8 * noise(x, y, 2));
}

std::unique_ptr<Bench> run(const Scheme& scheme, const Scene& scene, const Turn& turn) {
    Scene turned = turn.scene(scene);
    turned.solver = scheme.options;
    auto bench = std::make_unique<Bench>(turned);
    const auto at = [&](auto field) {
        return [field, turn](int x, int y) {
            const auto [a, b] = turn.cell(x, y);
            return field(a, b);
        };
    };
    bench->set_support(at([](int x, int y) { return 0.3 * noise(x, y, 3); }));
    bench->fill(at([](int x, int y) { return thickness(x, y); }));
    bench->tint(0, at([](int x, int y) { return 100 * noise(x, y, 4); }));
    bench->tint(9, at([](int x, int) { return x < 40 ? 0.02 : 30.0; }));
    const double dt = scheme.step_in_limits * bench->solver->stable_step_s(4.0);
    for (int step = 0; step < scheme.turning_steps; ++step)
        bench->solver->advance(dt);
    return bench;
}

/// The velocity of the straight canvas through the face of the turned one between (x, y) and (x + 1, y),
/// or, for `is_y`, (x, y + 1).
double turned_velocity(const Bench& straight, const Turn& turn, int x, int y, bool is_y) {
    const auto [a, b] = turn.cell(x, y);
    const auto [c, d] = is_y ? turn.cell(x, y + 1) : turn.cell(x + 1, y);
    const int first_x = std::min(a, c), first_y = std::min(b, d);
    const bool along_x = a != c;
    const double velocity = along_x ? straight.u(first_x, first_y) : straight.v(first_x, first_y);
    return first_x == a && first_y == b ? velocity : -velocity;
}

using SymmetryCase = std::tuple<Scheme, Turn, Paint>;
class TurnedCanvas : public testing::TestWithParam<SymmetryCase> {};

void expect_alike(const Bench& turned, const Bench& straight, const Turn& turn, double most) {
    double difference = 0, sum = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const auto [a, b] = turn.cell(x, y);
            difference += std::abs(turned.h(x, y) - straight.h(a, b));
            sum += straight.h(a, b);
        }
    EXPECT_LT(difference, most * sum);
}

void expect_same(const Bench& turned, const Bench& straight, const Turn& turn) {
    int moving = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const auto [a, b] = turn.cell(x, y);
            ASSERT_EQ(turned.state.thickness.at(x, y), straight.state.thickness.at(a, b))
                << x << ' ' << y;
            ASSERT_EQ(turned.state.paint.at(x, y), straight.state.paint.at(a, b)) << x << ' ' << y;
            if (x + 1 < kSide) {
                ASSERT_EQ(turned.u(x, y), turned_velocity(straight, turn, x, y, false)) << x << ' ' << y;
                moving += turned.u(x, y) != 0 ? 1 : 0;
            }
            if (y + 1 < kSide) {
                ASSERT_EQ(turned.v(x, y), turned_velocity(straight, turn, x, y, true)) << x << ' ' << y;
            }
        }
    EXPECT_EQ(turned.solver->runoff().thickness, straight.solver->runoff().thickness);
    EXPECT_GT(moving, 500);
}
TEST_P(TurnedCanvas, GivesTheTurnedFilm) {
    const auto& [scheme, turn, paint] = GetParam();
    const auto straight = run(scheme, paint.scene, {"Straight", false, false, false});
    const auto turned = run(scheme, paint.scene, turn);
    if (scheme.turning_error > 0)
        expect_alike(*turned, *straight, turn, scheme.turning_error);
    else
        expect_same(*turned, *straight, turn);
}

INSTANTIATE_TEST_SUITE_P(Paints, TurnedCanvas,
                         testing::Combine(testing::ValuesIn(all_schemes()), testing::ValuesIn(kTurns),
                                          testing::ValuesIn(paints())),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + std::get<1>(test.param).name +
                                    std::get<2>(test.param).name;
                         });

}  // namespace
}  // namespace pastoso::film::test
