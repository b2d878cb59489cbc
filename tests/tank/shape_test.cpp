#include "tank/shape.hpp"

#include "core/random.hpp"
#include "tank/meshes.hpp"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

/// Coordinates below one metre are floats, and a few of them are added.
constexpr float kRounding_m = 3e-7F;

Shape shape(auto form) {
    return Shape{std::move(form)};
}

struct Expected {
    glm::vec3 point_m;
    float distance_m;
};

void expect_distances(const Shape& of, const std::vector<Expected>& all) {
    const ShapeDistance distance(of);
    for (const auto& [point, expected] : all)
        EXPECT_NEAR(distance(point), expected, kRounding_m)
            << "at " << point.x << ", " << point.y << ", " << point.z;
}

liquid::Cup straight_cup() {
    liquid::Cup cup;
    cup.slope = 0.0F;
    return cup;
}

MeshBody mesh_body(liquid::TriangleMesh mesh) {
    return {"body.obj", std::make_shared<const liquid::TriangleMesh>(std::move(mesh)), {}, 1.0F};
}

Combined combined(Combination rule, std::vector<Shape> parts) {
    return {rule, std::move(parts)};
}

const Sphere kSphere{{0.1F, 0.2F, 0.3F}, 0.05F};
const Block kBlock{{0, 0, 0}, {0.2F, 0.1F, 0.4F}};
const Cylinder kCylinder{{0, 0, 0}, {0.3F, 0.4F, 0}, 0.1F};
const Torus kTorus{{0, 0, 0}, {0, 0, 2}, 0.1F, 0.03F};

TEST(Shape, DistancesFromASphere) {
    expect_distances(shape(kSphere), {{{0.1F, 0.2F, 0.3F}, -0.05F},
                                      {{0.1F, 0.2F, 0.4F}, 0.05F},
                                      {{0.4F, 0.6F, 0.3F}, 0.45F},
                                      {{0.1F, 0.16F, 0.27F}, 0.0F}});
}

TEST(Shape, DistancesFromABlock) {
    expect_distances(shape(kBlock), {{{0.1F, 0.05F, 0.2F}, -0.05F},
                                     {{0.19F, 0.05F, 0.2F}, -0.01F},
                                     {{0.25F, 0.05F, 0.2F}, 0.05F},
                                     {{-0.05F, 0.05F, 0.2F}, 0.05F},
                                     {{0.23F, 0.14F, 0.2F}, 0.05F},
                                     {{0.22F, 0.13F, 0.46F}, 0.07F},
                                     {{0.2F, 0.05F, 0.2F}, 0.0F}});
}

TEST(Shape, DistancesFromACylinder) {
    const glm::vec3 middle(0.15F, 0.2F, 0), along(0.6F, 0.8F, 0), across(-0.8F, 0.6F, 0);
    expect_distances(shape(kCylinder), {{middle, -0.1F},
                                        {middle + 0.3F * across, 0.2F},
                                        {middle + 0.3F * along, 0.05F},
                                        {middle - 0.3F * along, 0.05F},
                                        {middle + 0.28F * along + 0.14F * across, 0.05F},
                                        {middle + 0.24F * along, -0.01F},
                                        {middle + glm::vec3(0, 0, 0.07F), -0.03F}});
}

TEST(Shape, DistancesFromATorus) {
    expect_distances(shape(kTorus), {{{0, 0, 0}, 0.07F},
                                     {{0.1F, 0, 0}, -0.03F},
                                     {{0, -0.1F, 0.05F}, 0.02F},
                                     {{0.2F, 0, 0}, 0.07F},
                                     {{0, 0.13F, 0.04F}, 0.02F},
                                     {{0, 0, 0.24F}, 0.23F}});
    expect_distances(shape(Torus{{0, 0, 0.5F}, {-3, 0, 0}, 0.1F, 0.03F}),
                     {{{0, 0.1F, 0.5F}, -0.03F}, {{0.05F, 0, 0.4F}, 0.02F}});
}

TEST(Shape, DistancesFromTheGlassOfACup) {
    const liquid::Cup cup = straight_cup();
    const auto at = [&](float radius, float z) { return glm::vec3(0.05F + radius, 0.05F, z); };
    expect_distances(shape(CupGlass{cup}), {{at(0, 0.00125F), -0.00275F},
                                            {at(0.0341F, 0.05F), -0.0011F},
                                            {at(0, 0.05F), 0.033F},
                                            {at(-0.0341F, 0.1F), 0.002F},
                                            {at(-0.0402F, 0.05F), 0.005F},
                                            {at(0.01F, -0.0035F), 0.002F},
                                            {at(0.0382F, 0.102F), 0.005F},
                                            {at(0, 0.005F), 0.001F},
                                            {at(0.02F, 0.004F), 0.0F}});
    // In a corner the outside of the wall is nearest along its normal.
    const liquid::Cup sloped;
    const float length = std::sqrt(1.01F), radius = sloped.inner_radius_m(0.05F) + sloped.wall_m;
    expect_distances(shape(CupGlass{sloped}),
                     {{at(radius + 0.001F / length, 0.05F - 0.0001F / length), 0.001F},
                      {at(radius - 0.001F / length, 0.05F + 0.0001F / length), -0.001F}});
}

TEST(Shape, DistancesFromAMesh) {
    MeshBody body = mesh_body(test::block_mesh({0, 0, 0}, {20, 10, 40}));
    body.scale = 0.01F;
    body.position_m = {0.5F, 0, -0.25F};
    expect_distances(shape(body), {{{0.6F, 0.05F, -0.05F}, -0.05F},
                                   {{0.75F, 0.05F, -0.05F}, 0.05F},
                                   {{0.72F, 0.13F, 0.21F}, 0.07F}});
    const ShapeDistance distance(shape(body));
    EXPECT_EQ(distance({3, 3, 3}, 0.3F), 0.3F);
    EXPECT_EQ(distance({0.6F, 0.05F, -0.05F}, 0.03F), -0.03F);
}

TEST(Shape, CombinationsTakeLeastLargestAndLargestOfTheOpposite) {
    const Shape a = shape(Sphere{{0, 0, 0}, 0.2F}), b = shape(Sphere{{0.3F, 0, 0}, 0.2F});
    const Shape c = shape(Sphere{{0, 0.3F, 0}, 0.2F});
    expect_distances(shape(combined(Combination::Union, {a, b, c})),
                     {{{0.6F, 0, 0}, 0.1F}, {{-0.1F, 0, 0}, -0.1F}, {{0, 0.55F, 0}, 0.05F}});
    expect_distances(shape(combined(Combination::Intersection, {a, b})),
                     {{{0.15F, 0, 0}, -0.05F}, {{0.3F, 0, 0}, 0.1F}, {{0, 0, 0}, 0.1F}});
    expect_distances(shape(combined(Combination::Difference, {a, b, c})),
                     {{{0, 0, 0}, -0.1F}, {{0.15F, 0, 0}, 0.05F}, {{0, 0.15F, 0}, 0.05F}});
    // Combined again: b and c without what both share with a.
    const Shape rest =
        shape(combined(Combination::Difference, {shape(combined(Combination::Union, {b, c})),
                                                 shape(combined(Combination::Intersection, {a, b}))}));
    expect_distances(rest, {{{0.4F, 0, 0}, -0.1F}, {{0.15F, 0, 0}, 0.05F}, {{0, 0.15F, 0}, -0.05F}});
    EXPECT_FLOAT_EQ(ShapeDistance(shape(combined(Combination::Intersection, {a})))({0.3F, 0, 0}), 0.1F);
}

std::vector<Shape> all_forms() {
    const Shape mesh = shape(mesh_body(test::sphere_mesh({0.1F, 0, 0}, 0.1F, 4)));
    return {shape(kSphere),
            shape(kBlock),
            shape(kCylinder),
            shape(kTorus),
            shape(CupGlass{}),
            mesh,
            shape(combined(Combination::Difference, {mesh, shape(kBlock), shape(kTorus)})),
            shape(combined(Combination::Union, {shape(kBlock), mesh, shape(kCylinder)}))};
}

glm::vec3 random_point(std::uint32_t index, std::uint32_t seed) {
    const glm::vec3 share(core::uniform_noise(index, seed), core::uniform_noise(index, seed + 100),
                          core::uniform_noise(index, seed + 200));
    return glm::vec3(-0.3F) + 0.9F * share;
}

constexpr float kStep_m = 1e-4F;

glm::vec3 gradient(const ShapeDistance& distance, const glm::vec3& point_m) {
    glm::vec3 result;
    for (const int axis : {0, 1, 2}) {
        glm::vec3 aside(0.0F);
        aside[axis] = kStep_m;
        result[axis] = (distance(point_m + aside) - distance(point_m - aside)) / (2.0F * kStep_m);
    }
    return result;
}

/// The distance grows by one metre a metre, but where two points of the surface are equally near: in
/// hollow edges, which are few. Points are found by walking to the surface and 1 to 2 mm off it.
TEST(Shape, TheGradientIsOneLong) {
    // A difference of two distances with errors of kRounding_m, along each of three axes; and edges,
    // around which the distance is as curved as 1 mm, give differences (step / 1 mm)^2 / 6 off.
    constexpr float kError = 1.8F * kRounding_m / kStep_m + 0.01F / 6.0F;
    constexpr int kPoints = 1000;
    std::uint32_t number = 0;
    for (const Shape& form : all_forms()) {
        const ShapeDistance distance(form);
        int near = 0, others = 0;
        for (std::uint32_t n = 0; n < kPoints; ++n) {
            const glm::vec3 start = random_point(n, number);
            const float aside = 0.001F + 0.001F * core::uniform_noise(n, 55);
            const glm::vec3 point = start - (distance(start) - aside) * gradient(distance, start);
            if (std::abs(distance(point) - aside) > 1e-4F) continue;
            ++near;
            if (std::abs(glm::length(gradient(distance, point)) - 1.0F) > kError) ++others;
        }
        EXPECT_GE(near, kPoints / 2) << "form " << number;
        EXPECT_LE(others, near / 20) << "form " << number << ", of " << near;
        ++number;
    }
}

TEST(Shape, WithinTheReachDistancesAreTheSameAndBeyondItTheSideIs) {
    std::uint32_t number = 0;
    for (const Shape& form : all_forms()) {
        const ShapeDistance distance(form);
        for (std::uint32_t n = 0; n < 3000; ++n) {
            const glm::vec3 point = random_point(n, number);
            const float reach = 0.1F * core::uniform_noise(n, 77) + 1e-4F;
            const float whole = distance(point), near = distance(point, reach);
            if (std::abs(whole) < reach) {
                EXPECT_EQ(near, whole) << "form " << number << ", point " << n;
            } else {
                EXPECT_EQ(near < 0.0F, whole < 0.0F) << "form " << number << ", point " << n;
                EXPECT_GE(std::abs(near), reach) << "form " << number << ", point " << n;
            }
        }
        ++number;
    }
}

void mirror(glm::vec3& vector, int axis) {
    vector[axis] = -vector[axis];
}

Shape mirrored(Shape form, int axis) {
    if (auto* sphere = std::get_if<Sphere>(&form.form)) mirror(sphere->centre_m, axis);
    if (auto* block = std::get_if<Block>(&form.form)) {
        mirror(block->low_m, axis);
        mirror(block->high_m, axis);
        std::swap(block->low_m[axis], block->high_m[axis]);
    }
    if (auto* cylinder = std::get_if<Cylinder>(&form.form)) {
        mirror(cylinder->from_m, axis);
        mirror(cylinder->to_m, axis);
    }
    if (auto* torus = std::get_if<Torus>(&form.form)) {
        mirror(torus->centre_m, axis);
        mirror(torus->axis, axis);
    }
    if (auto* body = std::get_if<MeshBody>(&form.form))
        body->mesh = std::make_shared<const liquid::TriangleMesh>(test::mirrored(*body->mesh, axis));
    if (auto* parts = std::get_if<Combined>(&form.form))
        for (Shape& part : parts->parts)
            part = mirrored(part, axis);
    return form;
}

TEST(Shape, MirroredShapesHaveMirroredDistances) {
    for (const Shape& form : all_forms()) {
        if (std::holds_alternative<CupGlass>(form.form)) continue;  // stands upright
        const ShapeDistance distance(form);
        for (const int axis : {0, 1, 2}) {
            const ShapeDistance other(mirrored(form, axis));
            for (std::uint32_t n = 0; n < 300; ++n) {
                glm::vec3 point = random_point(n, 9);
                const float expected = distance(point);
                mirror(point, axis);
                EXPECT_NEAR(other(point), expected, kRounding_m);
            }
        }
    }
}

TEST(Shape, MeshesAreComparedByWhatTheyHold) {
    const MeshBody body = mesh_body(test::octahedron());
    EXPECT_EQ(body, mesh_body(test::octahedron()));
    EXPECT_NE(body, mesh_body(test::inside_out(test::octahedron())));
    EXPECT_NE(body, (MeshBody{"body.obj", nullptr, {}, 1.0F}));
}

}  // namespace
}  // namespace pastoso::tank
