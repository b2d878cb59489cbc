// Velocities continued into the air.
#include "tank/extension.hpp"

#include "tank/level_cases.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using cases::sampled;
using cases::unit_box;
using Velocity = std::function<glm::vec3(const glm::vec3& point_m)>;

constexpr float kReach_cells = 5.0F, kUnset = 1e6F;

template <class Body>
void for_each_face(const grid::BoxShape& shape, const Body& body) {
    for (const int axis : liquid::kAxes) {
        const auto [nx, ny, nz] = liquid::sample_counts(shape, liquid::face_across(axis));
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i)
                    body(axis, i, j, k,
                         (glm::vec3(i, j, k) + liquid::offset_cells(liquid::face_across(axis))) *
                             shape.cell_m);
    }
}

/// Known where a face's middle is in the liquid.
liquid::VelocityField extended(const grid::BoxShape& shape, const cases::Distance& distance,
                               const Velocity& exact, int threads = 2) {
    core::ThreadPool pool(threads);
    liquid::VelocityField known(shape), velocity(shape);
    for_each_face(shape, [&](int axis, int i, int j, int k, const glm::vec3& at_m) {
        const bool in_liquid = distance(at_m) < 0.0F;
        known.along(axis).at(i, j, k) = in_liquid ? 1.0F : 0.0F;
        velocity.along(axis).at(i, j, k) = in_liquid ? exact(at_m)[axis] : kUnset;
    });
    VelocityExtension(shape).extend(sampled(shape, distance), known, kReach_cells, velocity, pool);
    return velocity;
}

/// The largest |u - exact| of the faces within some cells of the liquid.
float largest_error(const liquid::VelocityField& velocity, const cases::Distance& distance,
                    const Velocity& exact, float within_cells) {
    float largest = 0.0F;
    for_each_face(velocity.shape(), [&](int axis, int i, int j, int k, const glm::vec3& at_m) {
        if (distance(at_m) < within_cells * velocity.shape().cell_m)
            largest = std::max(largest, std::abs(velocity.along(axis).at(i, j, k) - exact(at_m)[axis]));
    });
    return largest;
}

const glm::vec3 kCentre_m(0.5F, 0.52F, 0.47F);

TEST(VelocityExtension, KeepsConstants) {
    const grid::BoxShape shape = unit_box(24);
    const auto constant = [](const glm::vec3&) { return glm::vec3(0.3F, -0.7F, 1.1F); };
    const auto ball = cases::sphere(kCentre_m, 0.2F);
    const liquid::VelocityField velocity = extended(shape, ball, constant);
    // Rounding of weighted means.
    EXPECT_LT(largest_error(velocity, ball, constant, kReach_cells + 0.9F), 1e-6F);
    // Far from the liquid nothing is touched.
    EXPECT_EQ(velocity.x.at(0, 0, 0), kUnset);
}

TEST(VelocityExtension, IsExactForLinearFieldsThatAreConstantAlongAPlanesNormals) {
    const grid::BoxShape shape = unit_box(32);
    const glm::vec3 normal = glm::normalize(glm::vec3(1.0F, 2.0F, 3.0F));
    const auto plane = [=](const glm::vec3& p) { return glm::dot(p - kCentre_m, normal); };
    const auto linear = [=](const glm::vec3& p) {
        const glm::vec3 beside = p - glm::dot(p, normal) * normal;
        return glm::vec3(beside.x, beside.y - beside.z, 2.0F * beside.z);
    };
    const liquid::VelocityField velocity = extended(shape, plane, linear);
    // Where the box ends the way to the liquid may leave it: so many steps back along each axis lead
    // there from four cells away.
    float largest = 0.0F;
    for_each_face(shape, [&](int axis, int i, int j, int k, const glm::vec3& at_m) {
        if (i >= 16 && j >= 8 && k >= 6 && plane(at_m) < 4.0F * shape.cell_m)
            largest = std::max(largest, std::abs(velocity.along(axis).at(i, j, k) - linear(at_m)[axis]));
    });
    EXPECT_LT(largest, 5e-6F);
}

TEST(VelocityExtension, AroundABallIsOfFirstOrder) {
    const auto ball = cases::sphere(kCentre_m, 0.22F);
    // Of the direction from the centre alone.
    const auto field = [](const glm::vec3& p) {
        const glm::vec3 n = glm::normalize(p - kCentre_m + glm::vec3(1e-9F));
        return glm::vec3(n.x * n.y, n.z, n.x * n.x - n.y);
    };
    const auto error = [&](int cells) {
        // The same distance in metres.
        return largest_error(extended(unit_box(cells), ball, field), ball, field,
                             4.0F * static_cast<float>(cells) / 64.0F);
    };
    const float coarse = error(32), fine = error(64);
    // Measured: 0.055 and 0.027 of values up to 2.
    EXPECT_LT(fine, 0.04F);
    EXPECT_GT(std::log2(coarse / fine), 0.8F);
}

TEST(VelocityExtension, AMirroredBallHasTheMirroredVelocity) {
    const grid::BoxShape shape = unit_box(16);
    const auto mirrored = [](const glm::vec3& p) { return glm::vec3(1.0F - p.x, p.y, p.z); };
    const auto ball = cases::sphere({0.4F, 0.5F, 0.6F}, 0.2F);
    const auto other = [&](const glm::vec3& p) { return ball(mirrored(p)); };
    const Velocity swirl = [](const glm::vec3& p) { return glm::vec3(p.y * p.z, p.x - p.z, p.x * p.y); };
    const Velocity other_swirl = [&](const glm::vec3& p) {
        const glm::vec3 u = swirl(mirrored(p));
        return glm::vec3(-u.x, u.y, u.z);
    };
    const liquid::VelocityField a = extended(shape, ball, swirl),
                                b = extended(shape, other, other_swirl);
    // Distances are rounded differently.
    for_each_face(shape, [&](int axis, int i, int j, int k, const glm::vec3& at_m) {
        if (ball(at_m) > 4.9F * shape.cell_m) return;
        if (axis == 0)
            ASSERT_NEAR(a.x.at(i, j, k), -b.x.at(16 - i, j, k), 1e-5F);
        else
            ASSERT_NEAR(a.along(axis).at(i, j, k), b.along(axis).at(15 - i, j, k), 1e-5F);
    });
}

TEST(VelocityExtension, FacesWithoutAWayToTheLiquidTakeTheMeanOfTheirNeighbours) {
    core::ThreadPool pool(1);
    const grid::BoxShape shape{8, 8, 8, 1.0F};
    // phi falls away from what is known.
    const grid::BoxField phi = sampled(shape, [](const glm::vec3& p) { return 2.0F - p.x; });
    liquid::VelocityField known(shape), velocity(shape);
    for (int k = 0; k < 8; ++k)
        for (int j = 0; j < 9; ++j) {
            known.y.at(0, j, k) = 1.0F;
            velocity.y.at(0, j, k) = 3.0F;
        }
    VelocityExtension(shape).extend(phi, known, kReach_cells, velocity, pool);
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(velocity.y.at(i, 4, 4), 3.0F);
    EXPECT_EQ(velocity.x.at(4, 4, 4), 0.0F);
}

TEST(VelocityExtension, SomeRingsBeyondTheReachAreMeans) {
    core::ThreadPool pool(1);
    const grid::BoxShape shape{4, 4, 16, 1.0F};
    // The distance is known to 3 cells.
    const grid::BoxField phi =
        sampled(shape, [](const glm::vec3& p) { return std::min(p.z - 4.0F, 3.0F); });
    liquid::VelocityField known(shape), velocity(shape);
    for_each_face(shape, [&](int axis, int i, int j, int k, const glm::vec3& at_m) {
        if (at_m.z < 4.0F) known.along(axis).at(i, j, k) = 1.0F;
        velocity.along(axis).at(i, j, k) = at_m.z < 4.0F ? at_m.x : kUnset;
    });
    VelocityExtension(shape).extend(phi, known, 3.0F, velocity, pool);
    for (int k = 4; k < 7 + kMeanRings; ++k)
        EXPECT_EQ(velocity.x.at(2, 1, k), 2.0F);
    EXPECT_EQ(velocity.x.at(2, 1, 7 + kMeanRings), kUnset);
}

TEST(VelocityExtension, WhereNothingIsKnownAllStays) {
    const grid::BoxShape shape = unit_box(8);
    core::ThreadPool pool(2);
    const liquid::VelocityField nothing(shape);
    liquid::VelocityField velocity(shape);
    for_each_face(shape, [&](int axis, int i, int j, int k, const glm::vec3& at_m) {
        velocity.along(axis).at(i, j, k) = at_m[axis];
    });
    const liquid::VelocityField before = velocity;
    // Less liquid than a face would see.
    const auto distance = [](const glm::vec3& at_m) { return glm::distance(at_m, kCentre_m) + 0.01F; };
    VelocityExtension(shape).extend(sampled(shape, distance), nothing, kReach_cells, velocity, pool);
    EXPECT_EQ(velocity, before);
}

TEST(VelocityExtension, GivesTheSameBitsOnAnyNumberOfThreads) {
    const grid::BoxShape shape = unit_box(24);
    const auto ball = cases::sphere(kCentre_m, 0.2F);
    const Velocity swirl = [](const glm::vec3& p) { return glm::vec3(p.y * p.z, p.x - p.z, p.x * p.y); };
    const liquid::VelocityField one = extended(shape, ball, swirl, 1);
    for (const int threads : {2, 3})
        EXPECT_TRUE(extended(shape, ball, swirl, threads) == one);
}

}  // namespace
}  // namespace pastoso::tank
