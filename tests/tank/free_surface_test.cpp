#include "tank/free_surface.hpp"

#include "tank_cases.hpp"

#include <cmath>
#include <functional>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

const grid::BoxShape kBox = {16, 12, 20, 0.05F};
constexpr float kFall_m_s = 0.327F;  // g dt

float no_solid(const glm::vec3&) {
    return 10.0F;
}
/// A ball that lies half within the liquid, cutting cells at all angles.
float ball(const glm::vec3& point_m) {
    return glm::distance(point_m, glm::vec3(0.41F, 0.28F, 0.52F)) - 0.17F;
}

liquid::RowRanges all_cells() {
    return liquid::RowRanges::whole(kBox, liquid::Location::Cell);
}

void set_level(const std::function<float(const glm::vec3&)>& level, FreeSurface& surface,
               core::ThreadPool& pool) {
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i)
                surface.level_m().at(i, j, k) = level((glm::vec3(i, j, k) + 0.5F) * kBox.cell_m);
    surface.update(all_cells(), pool);
}

/// What gravity gives every face in a step; walls stop it at the floor.
liquid::VelocityField falling() {
    liquid::VelocityField velocity(kBox);
    for (int k = 1; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i)
                velocity.z.at(i, j, k) = -kFall_m_s;
    return velocity;
}

/// The fastest of the open faces of cells of liquid.
float fastest_face(const Domain& domain, const FreeSurface& surface,
                   const liquid::VelocityField& velocity) {
    float fastest = 0.0F;
    const auto look = [&](int axis, int i, int j, int k) {
        if (domain.walls().open().along(axis).at(i, j, k) > 0.0F)
            fastest = std::max(fastest, std::abs(velocity.along(axis).at(i, j, k)));
    };
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i)
                if (surface.is_liquid(i, j, k))
                    for (const int axis : liquid::kAxes) {
                        look(axis, i, j, k);
                        look(axis, i + (axis == 0), j + (axis == 1), k + (axis == 2));
                    }
    return fastest;
}

/// Level liquid at rest stays so, wherever between the cells' middles its surface is: the specification
/// allows 5e-4 g dt.
TEST(FreeSurface, LevelLiquidRests) {
    core::ThreadPool pool(2);
    for (const auto& solid : {no_solid, ball}) {
        const Domain domain(kBox, solid);
        for (const float height_m : {0.53F, 0.545F, 0.56F, 0.572F}) {
            FreeSurface surface(domain);
            set_level([&](const glm::vec3& at_m) { return at_m.z - height_m; }, surface, pool);
            liquid::VelocityField velocity = falling();
            const auto result = surface.project(velocity, nullptr, {1e-6F, 60}, pool);
            EXPECT_TRUE(result.converged) << result.residual;
            EXPECT_LT(fastest_face(domain, surface, velocity), 5e-4F * kFall_m_s) << height_m;
            // rho g depth, as p dt / (rho cell).
            const float depth_m = height_m - 2.5F * kBox.cell_m;
            EXPECT_NEAR(surface.pressure().at(2, 3, 2), kFall_m_s * depth_m / kBox.cell_m,
                        1e-3F * kFall_m_s);
        }
    }
}

TEST(FreeSurface, LiquidInTheAirFallsAsItDid) {
    core::ThreadPool pool(2);
    const Domain domain(kBox, no_solid);
    FreeSurface surface(domain);
    set_level(
        [](const glm::vec3& at_m) {
            return glm::distance(at_m, {0.4F, 0.3F, 0.5F}) - 0.2F;
        },
        surface, pool);
    EXPECT_GT(surface.liquid_cells(), 200);
    liquid::VelocityField velocity = falling();
    surface.project(velocity, nullptr, {1e-6F, 60}, pool);
    EXPECT_EQ(velocity, falling());  // free of divergence already: no pressure at all
}

TEST(FreeSurface, LeavesNoDivergenceButTheGrowthAskedFor) {
    core::ThreadPool pool(2);
    const Domain domain(kBox, ball);
    FreeSurface surface(domain);
    set_level([](const glm::vec3& at_m) { return at_m.z + 0.2F * at_m.x - 0.6F; }, surface, pool);
    liquid::VelocityField velocity(kBox);
    std::uint32_t n = 0;
    for (const int axis : liquid::kAxes)
        for (float& value : velocity.along(axis).values())
            value = core::uniform_noise(n++, 7) - 0.5F;
    grid::BoxField growth(kBox);
    growth.at(5, 5, 3) = 0.25F;
    const auto result = surface.project(velocity, &growth, {1e-6F, 60}, pool);
    EXPECT_TRUE(result.converged);
    const liquid::VelocityField& open = domain.walls().open();
    for (int k = 0; k < kBox.nz; ++k)
        for (int j = 0; j < kBox.ny; ++j)
            for (int i = 0; i < kBox.nx; ++i) {
                if (!surface.is_liquid(i, j, k)) continue;
                const auto flux = [&](int axis, int di, int dj, int dk) {
                    return open.along(axis).at(i + di, j + dj, k + dk) *
                           velocity.along(axis).at(i + di, j + dj, k + dk);
                };
                const float outflow = flux(0, 1, 0, 0) - flux(0, 0, 0, 0) + flux(1, 0, 1, 0) -
                                      flux(1, 0, 0, 0) + flux(2, 0, 0, 1) - flux(2, 0, 0, 0);
                // 1e-6 of the root-sum-square of some thousand sources of about 0.5.
                ASSERT_NEAR(outflow, growth.at(i, j, k), 1e-4F) << i << ' ' << j << ' ' << k;
            }
}

/// Without a surface the pressure is known up to a constant only.
TEST(FreeSurface, AFullTankNeedsNoAir) {
    core::ThreadPool pool(1);
    const Domain domain(kBox, no_solid);
    FreeSurface surface(domain);
    set_level([](const glm::vec3&) { return -1.0F; }, surface, pool);
    EXPECT_EQ(surface.liquid_cells(), 16L * 12 * 20);
    liquid::VelocityField velocity = falling();
    EXPECT_TRUE(surface.project(velocity, nullptr, {1e-5F, 60}, pool).converged);
    EXPECT_LT(fastest_face(domain, surface, velocity), 1e-4F * kFall_m_s);
}

TEST(FreeSurface, WithoutLiquidThereIsNothingToDo) {
    core::ThreadPool pool(1);
    const Domain domain(kBox, no_solid);
    FreeSurface surface(domain);
    set_level([](const glm::vec3&) { return 1.0F; }, surface, pool);
    liquid::VelocityField velocity = falling();
    EXPECT_EQ(surface.project(velocity, nullptr, {1e-5F, 60}, pool).iterations, 0);
    EXPECT_EQ(velocity, falling());
}

/// A surface after another one leaves nothing of it behind.
TEST(FreeSurface, ForgetsTheLastSurface) {
    core::ThreadPool pool(2);
    const Domain domain(kBox, ball);
    const auto low = [](const glm::vec3& at_m) { return at_m.z - 0.31F; };
    FreeSurface used(domain), fresh(domain);
    set_level([](const glm::vec3& at_m) { return at_m.x - 0.5F; }, used, pool);
    set_level(low, used, pool);
    set_level(low, fresh, pool);
    liquid::VelocityField a = falling(), b = falling();
    EXPECT_EQ(used.project(a, nullptr, {1e-5F, 60}, pool), fresh.project(b, nullptr, {1e-5F, 60}, pool));
    EXPECT_EQ(a, b);
}

TEST(FreeSurface, IsTheSameOnAnyNumberOfThreads) {
    core::ThreadPool single(1), several(3);
    const Domain domain(kBox, ball);
    FreeSurface a(domain), b(domain);
    const auto level = [](const glm::vec3& at_m) { return at_m.z + 0.3F * at_m.y - 0.6F; };
    set_level(level, a, single);
    set_level(level, b, several);
    liquid::VelocityField u = falling(), v = falling();
    a.project(u, nullptr, {1e-5F, 60}, single);
    b.project(v, nullptr, {1e-5F, 60}, several);
    EXPECT_EQ(u, v);
}

}  // namespace
}  // namespace pastoso::tank
