#include "tank/domain.hpp"

#include "tank_cases.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

const grid::BoxShape kBox = {20, 16, 12, 0.05F};

liquid::RowRanges everywhere() {
    liquid::RowRanges rows(kBox);
    for (int k = 0; k <= kBox.nz; ++k)
        for (int j = 0; j <= kBox.ny; ++j)
            rows.at(j, k) = {0, kBox.nx + 1};
    return rows;
}

float ball(const glm::vec3& point_m) {
    return glm::distance(point_m, glm::vec3(0.5F, 0.4F, 0.3F)) - 0.15F;
}
/// A half-space below a slope of 45 degrees.
float slope(const glm::vec3& point_m) {
    return (point_m.x + point_m.z - 0.6F) * std::sqrt(0.5F);
}

TEST(Domain, SharesAreWhatSolidsLeave) {
    const Domain domain(kBox, ball);
    double taken = 0.0;
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i)
                taken += 1.0 - static_cast<double>(domain.share().at(i, j, k));
    const double expected = 4.0 / 3.0 * 3.14159265 * 0.15 * 0.15 * 0.15;
    // Three cells of radius: the smoothed edge counts the curvature as well.
    EXPECT_NEAR(taken * kBox.cell_volume_m3(), expected, 0.05 * expected);
    EXPECT_TRUE(domain.has_solids());
    EXPECT_FALSE(Domain(kBox, [](const glm::vec3&) { return 1.0F; }).has_solids());
}

TEST(Domain, BringsPointsOutOfSolidsAndIntoTheBox) {
    const Domain domain(kBox, ball);
    const float margin_m = 0.005F;
    for (int n = 0; n < 300; ++n) {
        const auto number = [&](std::uint32_t stream) {
            return 1.2F * core::uniform_noise(static_cast<std::uint32_t>(n), stream) - 0.1F;
        };
        const glm::vec3 point_m = {number(1), number(2), number(3)};
        const glm::vec3 within = domain.brought_within(point_m, margin_m);
        // The distance is interpolated between cells, which errs by a curvature's worth.
        EXPECT_GT(ball(within), margin_m - 0.02F * kBox.cell_m * 3.0F);
        for (const int axis : liquid::kAxes) {
            EXPECT_GE(within[axis], margin_m - 1e-6F);
            EXPECT_LE(
                within[axis],
                static_cast<float>(std::array{20, 16, 12}[static_cast<std::size_t>(axis)]) * 0.05F -
                    margin_m + 1e-6F);
        }
    }
    const glm::vec3 free_m = {0.1F, 0.1F, 0.1F};
    EXPECT_EQ(domain.brought_within(free_m, margin_m), free_m);
}

TEST(Domain, TheBoxLetsNothingThrough) {
    core::ThreadPool pool(2);
    const Domain domain(kBox, [](const glm::vec3&) { return 1.0F; });
    liquid::VelocityField velocity(kBox);
    for (const int axis : liquid::kAxes)
        for (float& value : velocity.along(axis).values())
            value = 1.0F;
    domain.stop_at_walls(everywhere(), velocity, pool);
    EXPECT_EQ(velocity.x.at(0, 3, 3), 0.0F);
    EXPECT_EQ(velocity.x.at(20, 3, 3), 0.0F);
    EXPECT_EQ(velocity.y.at(3, 16, 3), 0.0F);
    EXPECT_EQ(velocity.z.at(3, 3, 0), 0.0F);
    EXPECT_EQ(velocity.z.at(3, 3, 12), 0.0F);
    EXPECT_EQ(velocity.x.at(1, 3, 3), 1.0F);
}

/// What runs into a slope runs along it afterwards; what leaves it is let go.
TEST(Domain, SolidsStopWhatRunsIntoThem) {
    core::ThreadPool pool(1);
    const Domain domain(kBox, slope);
    for (const float towards : {-1.0F, 1.0F}) {
        liquid::VelocityField velocity(kBox);
        for (float& value : velocity.x.values())
            value = towards;
        domain.stop_at_walls(everywhere(), velocity, pool);
        int shut = 0;
        for (int i = 2; i < 18; ++i)
            for (int k = 2; k < 10; ++k) {
                if (domain.walls().open().x.at(i, 8, k) > 0.0F) continue;
                const float deep_m = -slope(
                    {0.05F * static_cast<float>(i), 0.425F, 0.05F * (static_cast<float>(k) + 0.5F)});
                if (deep_m > 2.5F * kBox.cell_m) continue;
                ++shut;
                EXPECT_NEAR(velocity.x.at(i, 8, k), towards < 0.0F ? -0.5F : 1.0F, 1e-3F);
            }
        EXPECT_GT(shut, 10);
    }
}

TEST(Domain, RefusesADistanceThatIsNone) {
    EXPECT_ANY_THROW(Domain(kBox, [](const glm::vec3&) { return NAN; }));
}

}  // namespace
}  // namespace pastoso::tank
