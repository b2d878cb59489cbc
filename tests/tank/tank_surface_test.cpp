#include "tank/tank_surface.hpp"

#include "tank_cases.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using liquid::TriangleMesh;

const grid::BoxShape kBox{16, 12, 20, 0.05F};  // 0.8 by 0.6 by 1 m

Domain domain(const liquid::SignedDistance& solid_m = [](const glm::vec3&) { return 10.0F; }) {
    return {kBox, solid_m};
}
TankFrame frame_of(const std::function<float(const glm::vec3&)>& level_m, int parts = 2) {
    TankFrame frame = {0.0, 0, liquid::SampledField(frame_lattice(kBox, parts)), grid::BoxField(kBox)};
    const liquid::Lattice& lattice = frame.level_m.lattice();
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i)
                frame.level_m.at(i, j, k) = level_m(lattice.point_m(i, j, k));
    return frame;
}
float pool_level_m(const glm::vec3& at_m) {
    return at_m.z - 0.4F;
}

struct Cut {
    TriangleMesh mesh;
    double front_x_m;

    double volume_m3() const { return liquid::volume_m3(mesh); }
    float least(int axis) const {
        float value = std::numeric_limits<float>::max();
        for (const glm::vec3& at_m : mesh.positions_m)
            value = std::min(value, at_m[axis]);
        return value;
    }
    float most(int axis) const {
        float value = std::numeric_limits<float>::lowest();
        for (const glm::vec3& at_m : mesh.positions_m)
            value = std::max(value, at_m[axis]);
        return value;
    }
};
Cut cut(const TankFrame& frame, const Domain& domain, float reach_m = 0.0F) {
    core::ThreadPool pool(2);
    TankSurfaces surfaces(domain, pool);
    Cut cut;
    surfaces.make(frame, reach_m, cut.mesh);
    cut.front_x_m = surfaces.front_x_m();
    return cut;
}

/// Edges are cut off: less than half a spacing squared along 4 lower, 4 upper and 4 upright edges.
double edges_m3(const glm::vec3& size_m) {
    const double spacing_m = 0.025;
    return 0.5 * spacing_m * spacing_m * 4.0 * static_cast<double>(size_m.x + size_m.y + size_m.z);
}

TEST(TankSurface, APoolEndsAtTheWalls) {
    const Cut pool = cut(frame_of(pool_level_m), domain());
    EXPECT_NEAR(pool.volume_m3(), 0.8 * 0.6 * 0.4, edges_m3({0.8F, 0.6F, 0.4F}));
    for (const int axis : liquid::kAxes)
        EXPECT_NEAR(pool.least(axis), 0.0F, 1e-6F) << axis;
    EXPECT_NEAR(pool.most(0), 0.8F, 1e-6F);
    EXPECT_NEAR(pool.most(1), 0.6F, 1e-6F);
    EXPECT_NEAR(pool.most(2), 0.4F, 1e-6F);
    EXPECT_EQ(pool.mesh.normals.size(), pool.mesh.positions_m.size());
}

TEST(TankSurface, AFullTankIsTheBox) {
    const Cut full = cut(frame_of([](const glm::vec3&) { return -0.02F; }), domain());
    EXPECT_NEAR(full.volume_m3(), 0.48, edges_m3({0.8F, 0.6F, 1.0F}));
    EXPECT_NEAR(full.most(2), 1.0F, 1e-6F);
}

TEST(TankSurface, ABallInTheAirIsWhole) {
    const auto ball = [](const glm::vec3& at_m) {
        return glm::length(at_m - glm::vec3(0.4F, 0.3F, 0.5F)) - 0.2F;
    };
    const double exact = 4.0 / 3.0 * std::numbers::pi * 0.008;
    const double coarse = cut(frame_of(ball, 1), domain()).volume_m3() / exact - 1.0,
                 fine = cut(frame_of(ball, 2), domain()).volume_m3() / exact - 1.0;
    EXPECT_LT(std::abs(fine), 0.01);
    EXPECT_NEAR(coarse / fine, 4.0, 1.0);  // second order
}

/// Solid up to x = 0.2 m.
TEST(TankSurface, LiquidEndsAtSolids) {
    const Domain walled = domain([](const glm::vec3& at_m) { return at_m.x - 0.2F; });
    const Cut pool = cut(frame_of(pool_level_m), walled);
    EXPECT_NEAR(pool.volume_m3(), 0.6 * 0.6 * 0.4, edges_m3({0.6F, 0.6F, 0.4F}));
    EXPECT_NEAR(pool.least(0), 0.2F, 1e-5F);
}

TEST(TankSurface, ForPicturesItReachesIntoTheGlass) {
    const Domain walled = domain([](const glm::vec3& at_m) { return at_m.x - 0.2F; });
    const Cut pool = cut(frame_of(pool_level_m), walled, 0.01F);
    EXPECT_NEAR(pool.least(0), 0.19F, 1e-5F);
    EXPECT_NEAR(pool.least(1), -0.01F, 1e-5F);
    EXPECT_NEAR(pool.least(2), -0.01F, 1e-5F);
    EXPECT_NEAR(pool.most(0), 0.81F, 1e-5F);
    EXPECT_NEAR(pool.most(2), 0.4F, 1e-5F);
    const Cut full = cut(frame_of([](const glm::vec3&) { return -0.02F; }), walled, 0.01F);
    EXPECT_NEAR(full.most(2), 1.0F, 1e-5F);  // where there is no glass
}

TEST(TankSurface, TheFrontIsWhereTheLiquidEndsAndSprayDoesNotCount) {
    const auto dam = [](const glm::vec3& at_m) { return std::max(at_m.x - 0.3F, at_m.z - 0.5F); };
    // To the spacing, 25 mm.
    EXPECT_NEAR(cut(frame_of(dam), domain()).front_x_m, 0.3, 0.013);
    const auto with_drop = [&](const glm::vec3& at_m) {
        return std::min(dam(at_m), glm::length(at_m - glm::vec3(0.7125F, 0.3125F, 0.8125F)) - 0.02F);
    };
    EXPECT_NEAR(cut(frame_of(with_drop), domain()).front_x_m, 0.3, 0.013);
    EXPECT_GT(cut(frame_of(with_drop), domain()).most(0), 0.7F);
    const Cut nothing = cut(frame_of([](const glm::vec3&) { return 0.1F; }), domain());
    EXPECT_EQ(nothing.front_x_m, 0.0);
    EXPECT_TRUE(nothing.mesh.empty());
}

/// A tank's own frames enclose what its particles stand for.
TEST(TankSurface, OfParticlesItEnclosesTheirVolume) {
    core::ThreadPool pool(2);
    const LiquidTank tank(cases::dam(20, {0.5F, 1.0F, 0.6F}));
    TankSurfaces surfaces(tank.domain(), pool);
    TriangleMesh mesh;
    surfaces.make(tank.frame(2, pool), 0.0F, mesh);
    // The level around particles ends within a tenth of a cell of where they do, over 0.5 + 0.6 m2.
    EXPECT_NEAR(liquid::volume_m3(mesh), 0.3, 0.1 * 0.05 * 1.1);
}

}  // namespace
}  // namespace pastoso::tank
