#include "brush/motion_kernel.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr StepFlex kFlex = {.length_mm = 20.0,
                            .full_depth_mm = 6.4,
                            .per_full_depth = 1.0 / 6.4,
                            .bend = 0.5,
                            .splay = 0.22,
                            .tilt_gain = 0.8,
                            .stiff_end_mm = 1.6,
                            .restore = 0.02};
constexpr FerrulePose kHand = {.x_mm = 30.0,
                               .y_mm = 20.0,
                               .press = 0.3,
                               .lean_x = 0.2,
                               .lean_y = -0.1,
                               .cos_rotation = 0.6,
                               .sin_rotation = 0.8};

MotionColumns random_bristles(std::uint32_t seed) {
    MotionColumns columns{};
    for (std::uint32_t i = 0; i < MotionColumns::kCount; ++i) {
        const auto noise = [&](std::uint32_t stream) {
            return static_cast<double>(core::uniform_noise(seed * 100 + i, stream));
        };
        columns.root_x_mm[i] = 16.0 * noise(0) - 8.0;
        columns.root_y_mm[i] = 4.0 * noise(1) - 2.0;
        columns.per_distance[i] = noise(2);
        columns.deficit_mm[i] = 2.5 * noise(3);
        columns.stiffness[i] = 0.8 + 0.4 * noise(4);
        columns.was_down[i] = noise(5) < 0.5 ? 1.0 : 0.0;
        columns.x_mm[i] = kHand.x_mm + 20.0 * noise(6) - 10.0;
        columns.y_mm[i] = kHand.y_mm + 20.0 * noise(7) - 10.0;
    }
    return columns;
}

class MotionOnEverySet : public testing::TestWithParam<core::Isa> {};

TEST_P(MotionOnEverySet, GivesTheSameBitsAsTheBaseline) {
    if (GetParam() > core::best_isa())
        GTEST_SKIP() << "this processor has no " << core::name_of(GetParam());
    const auto& baseline = core::kernels<MotionKernels>(core::Isa::Baseline);
    const auto& kernels = core::kernels<MotionKernels>(GetParam());
    constexpr TuftGrid kGrid = {8.0, 2.2, 255.0, 159.0};
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        MotionColumns expected = random_bristles(seed), actual = expected;
        baseline.move(kFlex, kHand, expected);
        kernels.move(kFlex, kHand, actual);
        EXPECT_EQ(std::memcmp(&actual, &expected, sizeof actual), 0) << "seed " << seed;
        TuftCells expected_cells{}, cells{};
        baseline.compute_tufts(kGrid, expected, expected_cells);
        kernels.compute_tufts(kGrid, expected, cells);
        EXPECT_EQ(std::memcmp(&cells, &expected_cells, sizeof cells), 0) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, MotionOnEverySet,
                         testing::Values(core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512),
                         [](const auto& isa) { return core::name_of(isa.param); });

TEST(Motion, TipsStayWithinReachOfTheirRoots) {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        MotionColumns columns = random_bristles(seed);
        core::kernels<MotionKernels>().move(kFlex, kHand, columns);
        for (int i = 0; i < MotionColumns::kCount; ++i) {
            if (columns.depth_mm[i] <= 0.0) continue;
            const double spread =
                1.0 + kFlex.splay * columns.stiffness[i] * std::min(1.0, columns.depth_mm[i] / 6.4);
            const double root_x = 0.6 * columns.root_x_mm[i] - 0.8 * columns.root_y_mm[i];
            const double root_y = 0.8 * columns.root_x_mm[i] + 0.6 * columns.root_y_mm[i];
            const double away_mm = std::hypot(columns.x_mm[i] - kHand.x_mm - spread * root_x,
                                              columns.y_mm[i] - kHand.y_mm - spread * root_y);
            const double depth = columns.depth_mm[i];
            EXPECT_LE(away_mm, 0.5 * std::sqrt(depth * (40.0 - depth)) + 1e-12);
        }
    }
}

TEST(Motion, TuftsBeyondTheCanvasLieOnItsEdge) {
    MotionColumns columns{};
    columns.x_mm[0] = -7.0;
    columns.y_mm[0] = 1e9;
    columns.x_mm[1] = 4.06;
    TuftCells cells;
    core::kernels<MotionKernels>().compute_tufts({8.0, 2.2, 255.0, 159.0}, columns, cells);
    EXPECT_EQ(cells.x[0], 0);
    EXPECT_EQ(cells.right[0], 0);
    EXPECT_EQ(cells.above[0], 159);
    EXPECT_EQ(cells.x[1], 32);
    EXPECT_EQ(cells.left[1], 30);
    EXPECT_EQ(cells.right[1], 34);
}

}  // namespace
}  // namespace pastoso::brush
