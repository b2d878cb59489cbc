// Particles that mend a level set.
#include "tank/particle_level_set.hpp"

#include "tank/level_cases.hpp"
#include "tank/liquid_volume.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using cases::Flow;
using cases::Followed;
using cases::Following;
using cases::sampled;
using cases::unit_box;

const glm::vec3 kCentre_m(0.5F, 0.47F, 0.52F);

struct Seeded {
    grid::BoxField phi;
    SurfaceParticles particles;
};
Seeded seeded_ball(core::ThreadPool& pool, const SurfaceParticleSettings& settings = {}) {
    const grid::BoxShape shape = unit_box(24);
    Seeded seeded{sampled(shape, cases::sphere(kCentre_m, 0.25F)), SurfaceParticles(shape, settings)};
    continue_beyond_walls(seeded.phi);
    seeded.particles.seed(seeded.phi, pool);
    return seeded;
}

TEST(SurfaceParticles, AreSeededOnBothSidesAndTouchTheSurface) {
    core::ThreadPool pool(2);
    const Seeded seeded = seeded_ball(pool);
    const auto positions_m = seeded.particles.positions_m();
    const auto radii_m = seeded.particles.signed_radii_m();
    const float cell_m = 1.0F / 24.0F;
    double inside = 0.0;
    for (std::size_t p = 0; p < positions_m.size(); ++p) {
        const float distance_m = glm::length(positions_m[p] - kCentre_m) - 0.25F;
        // Trilinear values bend less than a sphere: by 1/8 cell^2 over the radius each way, 3 cells
        // within.
        constexpr float kBend_cells = 0.13F;
        ASSERT_LT(std::abs(distance_m), (3.0F + kBend_cells) * cell_m);
        const float radius_m = std::abs(radii_m[p]);
        if (std::abs(distance_m) > kBend_cells * cell_m) {
            ASSERT_EQ(distance_m > 0.0F, radii_m[p] > 0.0F);
        }
        ASSERT_NEAR(radius_m, std::clamp(std::abs(distance_m), 0.1F * cell_m, 0.5F * cell_m),
                    kBend_cells * cell_m);
        inside += distance_m < 0.0F ? 1.0 : 0.0;
    }
    // 32 per cell of the shells 3 cells thick, less what is cut off cells at the band's edge.
    const double r = 6.0, inner = 4.0 / 3.0 * 3.14159 * (r * r * r - 27.0);
    EXPECT_NEAR(inside, 32.0 * inner, 0.06 * 32.0 * inner);
}

TEST(SurfaceParticles, LeaveASurfaceAloneThatIsRight) {
    core::ThreadPool pool(2);
    Seeded seeded = seeded_ball(pool);
    const grid::BoxField before = seeded.phi;
    EXPECT_EQ(seeded.particles.mend(seeded.phi, pool), 0U);
    EXPECT_TRUE(seeded.phi == before);
}

TEST(SurfaceParticles, BringBackWhatPhiHasLost) {
    core::ThreadPool pool(2);
    for (const bool negated : {false, true}) {
        Seeded seeded = seeded_ball(pool);
        const double before_m3 = liquid_volume_m3(seeded.phi, pool);
        // Half a cell off all around, or on.
        grid::BoxField wrong = seeded.phi;
        for (float& value : wrong.values())
            value += (negated ? -0.5F : 0.5F) / 24.0F;
        const double wrong_m3 = liquid_volume_m3(wrong, pool);
        EXPECT_GT(seeded.particles.mend(wrong, pool), 1000U);
        const double after_m3 = liquid_volume_m3(wrong, pool);
        // Of both sides' claims the smaller holds: measured, a third comes back at once.
        EXPECT_GT(std::abs(wrong_m3 / before_m3 - 1.0), 0.2);
        EXPECT_LT(std::abs(after_m3 / before_m3 - 1.0), 0.7 * std::abs(wrong_m3 / before_m3 - 1.0));
    }
}

TEST(SurfaceParticles, OneThatHasEscapedClaimsItsBall) {
    // A drop's particle in air that phi knows nothing of.
    core::ThreadPool pool(1);
    const grid::BoxShape shape{8, 8, 8, 1.0F};
    grid::BoxField phi = sampled(shape, [](const glm::vec3& p) { return p.z - 2.3F; });
    SurfaceParticles particles(shape, {.per_cell = 1, .band_cells = 3.0F});
    particles.seed(phi, pool);
    const auto is_deep = [](const glm::vec3& p) { return p.z < 1.7F; };
    particles.remove_where([&](const glm::vec3& p) { return !is_deep(p); });
    ASSERT_GT(particles.positions_m().size(), 20U);
    for (const float radius_m : particles.signed_radii_m())
        ASSERT_EQ(radius_m, -0.5F);
    grid::BoxField air(shape, 2.0F);
    EXPECT_EQ(particles.mend(air, pool), particles.positions_m().size());
    float least = 2.0F;
    for (int k = 0; k < 8; ++k)
        for (int j = 0; j < 8; ++j)
            least = std::min(least, *std::min_element(air.row(j, k), air.row(j, k) + 8));
    EXPECT_GE(least, -0.5F);
    EXPECT_LT(least, -0.2F);
    // Escaped ones stay when the rest is seeded anew, as small as can be after their radii are adjusted.
    const grid::BoxField no_liquid(shape, 2.0F);
    const std::size_t count = particles.positions_m().size();
    particles.reseed(no_liquid, pool);
    EXPECT_GE(particles.positions_m().size(), count);
    particles.adjust_radii(no_liquid, pool);
    const auto radii_m = particles.signed_radii_m();
    EXPECT_EQ(std::ranges::count(radii_m, -0.1F), static_cast<long>(count));
}

TEST(SurfaceParticles, AreReseededWhereTheSurfaceHasGone) {
    core::ThreadPool pool(2);
    Seeded seeded = seeded_ball(pool);
    const std::size_t count = seeded.particles.positions_m().size();
    seeded.particles.reseed(seeded.phi, pool);
    // Cells at the band's edge are filled up.
    EXPECT_NEAR(static_cast<double>(seeded.particles.positions_m().size()) / static_cast<double>(count),
                1.0, 0.1);
    // The surface is three cells farther out: a cell beyond the old band there are particles on both
    // sides.
    grid::BoxField elsewhere =
        sampled(seeded.phi.shape(), cases::sphere(kCentre_m, 0.25F + 3.0F / 24.0F));
    continue_beyond_walls(elsewhere);
    seeded.particles.reseed(elsewhere, pool);
    const auto positions_m = seeded.particles.positions_m();
    std::size_t outside = 0;
    for (const glm::vec3& at_m : positions_m)
        outside += glm::length(at_m - kCentre_m) > 0.25F + 4.0F / 24.0F ? 1 : 0;
    EXPECT_GT(outside, positions_m.size() / 4);
}

TEST(SurfaceParticles, KeepTheVolumeInATurn) {
    core::ThreadPool pool(2);
    const Followed turned = cases::follow(Flow::Rotation, 48, {.particles_per_cell = 32}, pool);
    // The specification's bound is 2 %; measured -0.14 %.
    EXPECT_LT(std::abs(turned.volume_error), 0.01);
    EXPECT_LT(turned.shape_error, 0.02);
}

TEST(SurfaceParticles, KeepTheVolumeOfASheetThinnerThanCells) {
    core::ThreadPool pool(2);
    const Followed pulled = cases::follow(Flow::Enright, 32, {.particles_per_cell = 32}, pool);
    // The sheet is half a cell thick here; measured -2.6 % and 0.063. The level set alone loses 37 %.
    EXPECT_LT(std::abs(pulled.volume_error), 0.05);
    EXPECT_LT(pulled.shape_error, 0.1);
}

TEST(SurfaceParticles, KeepTheVolumeOfATankWhoseAirIsNotKnown) {
    core::ThreadPool pool(2);
    const Followed stirred = cases::follow(Flow::Tank, 32, {.particles_per_cell = 16}, pool);
    // Measured: 0.3 % and 0.011; the air's velocity has divergence, and its particles gather.
    EXPECT_LT(std::abs(stirred.volume_error), 0.008);
    EXPECT_LT(stirred.shape_error, 0.02);
}

TEST(SurfaceParticles, GiveTheSameBitsOnAnyNumberOfThreads) {
    const auto followed = [](int threads) {
        core::ThreadPool pool(threads);
        return cases::follow(Flow::Enright, 16, {.particles_per_cell = 16}, pool).phi;
    };
    const grid::BoxField one = followed(1);
    for (const int threads : {2, 3})
        EXPECT_TRUE(followed(threads) == one);
}

}  // namespace
}  // namespace pastoso::tank
