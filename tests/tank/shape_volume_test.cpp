// What shapes enclose, by counting the cells of a lattice, against what geometry says.
#include "tank/meshes.hpp"
#include "tank/shape.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

constexpr double kPi = std::numbers::pi;

/// From 1 to 0 as a distance goes from -1.5 to 1.5 cells, smoothly.
double share_within(double distance_cells) {
    const double s = -distance_cells / 1.5;
    if (s <= -1.0) return 0.0;
    if (s >= 1.0) return 1.0;
    return 0.5 * (1.0 + s + std::sin(kPi * s) / kPi);
}

/// In a cube around `middle`, of cells^3.
double counted_volume(const ShapeDistance& distance, const glm::vec3& middle, float side, int cells) {
    const float h = side / static_cast<float>(cells);
    double sum = 0.0;
    for (int k = 0; k < cells; ++k)
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const glm::vec3 at(static_cast<float>(i) + 0.5F, static_cast<float>(j) + 0.5F,
                                   static_cast<float>(k) + 0.5F);
                sum += share_within(
                    static_cast<double>(distance(middle + h * at - 0.5F * side, 2.0F * h) / h));
            }
    return sum * std::pow(static_cast<double>(h), 3);
}

/// A surface smeared over s cells encloses s^2 A'' more, A'' from its curvature: with half the cells'
/// size a quarter of the error is left. `largest`: what is left of the volume with twice the cells.
void expect_volume(const Shape& shape, const glm::vec3& middle, float side, double exact, double largest,
                   int cells = 48) {
    const ShapeDistance distance(shape);
    // Off the middle, so that no symmetry helps.
    const glm::vec3 aside = middle + side * glm::vec3(0.0137F, -0.0071F, 0.0093F);
    const double coarse = counted_volume(distance, aside, side, cells) / exact - 1.0;
    const double fine = counted_volume(distance, aside, side, 2 * cells) / exact - 1.0;
    EXPECT_LT(std::abs(fine), largest);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1) << coarse << " and " << fine;
}

Shape combined(Combination rule, std::vector<Shape> parts) {
    return {Combined{rule, std::move(parts)}};
}

double ball(double radius) {
    return 4.0 / 3.0 * kPi * std::pow(radius, 3);
}

/// What two balls of one radius share, their middles `apart`.
double lens(double radius, double apart) {
    return kPi / 12.0 * (4.0 * radius + apart) * std::pow(2.0 * radius - apart, 2);
}

/// Of a cone cut off at both ends.
double frustum(double height, double low_radius, double high_radius) {
    return kPi / 3.0 * height *
           (low_radius * low_radius + low_radius * high_radius + high_radius * high_radius);
}

const Shape kBall{Sphere{{0, 0, 0}, 0.1F}}, kOtherBall{Sphere{{0.06F, 0.06F, 0.03F}, 0.1F}};
constexpr double kApart = 0.09;

TEST(ShapeVolume, OfSimpleForms) {
    expect_volume(kBall, {0, 0, 0}, 0.26F, ball(0.1), 2e-3);
    expect_volume({Block{{-0.1F, -0.05F, 0}, {0.1F, 0.05F, 0.03F}}}, {0, 0, 0}, 0.26F, 0.2 * 0.1 * 0.03,
                  5e-3);
    expect_volume({Cylinder{{-0.06F, -0.08F, 0}, {0.06F, 0.08F, 0.02F}, 0.04F}}, {0, 0, 0}, 0.3F,
                  kPi * 0.0016 * std::sqrt(0.0404), 5e-3);
    expect_volume({Torus{{0, 0, 0}, {1, 2, 2}, 0.08F, 0.03F}}, {0, 0, 0}, 0.27F,
                  2.0 * kPi * kPi * 0.08 * 0.0009, 5e-3);
}

TEST(ShapeVolume, OfTheGlassOfACup) {
    liquid::Cup cup;
    // As thick as a few cells.
    cup.wall_m = 0.012F;
    cup.foot_m = -0.01F;
    const double wall = 0.012, slope = 0.1, foot = -0.01, floor = 0.004, rim = 0.098, radius = 0.033;
    const auto inner = [&](double z) { return radius + slope * (z - floor); };
    const double glass = frustum(rim - foot, inner(foot) + wall, inner(rim) + wall) -
                         frustum(rim - floor, inner(floor), inner(rim));
    expect_volume({CupGlass{cup}}, {0.05F, 0.05F, 0.045F}, 0.13F, glass, 5e-3);
}

TEST(ShapeVolume, OfMeshes) {
    const auto mesh = std::make_shared<const liquid::TriangleMesh>(test::sphere_mesh({}, 10.0F, 4));
    const Shape body{MeshBody{"ball.stl", mesh, {0.01F, 0, 0}, 0.01F}};
    expect_volume(body, {0.01F, 0, 0}, 0.26F, 1e-6 * liquid::volume_m3(*mesh), 2e-3, 32);
}

TEST(ShapeVolume, OfCombinations) {
    expect_volume(combined(Combination::Intersection, {kBall, kOtherBall}), {0.03F, 0.03F, 0.015F},
                  0.22F, lens(0.1, kApart), 5e-3);
    expect_volume(combined(Combination::Union, {kBall, kOtherBall}), {0.03F, 0.03F, 0.015F}, 0.32F,
                  2.0 * ball(0.1) - lens(0.1, kApart), 5e-3);
    expect_volume(combined(Combination::Difference, {kBall, kOtherBall}), {0, 0, 0}, 0.26F,
                  ball(0.1) - lens(0.1, kApart), 5e-3);
    const Shape block{Block{{-0.11F, -0.11F, -0.12F}, {0.11F, 0.11F, 0.12F}}};
    expect_volume(combined(Combination::Difference, {block, kBall}), {0, 0, 0}, 0.28F,
                  0.22 * 0.22 * 0.24 - ball(0.1), 5e-3);
}

}  // namespace
}  // namespace pastoso::tank
