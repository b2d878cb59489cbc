#include "trace/milk_medium.hpp"
#include "trace/numbers.hpp"
#include "trace/scenes.hpp"
#include "trace/world.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

constexpr int kRays = 20000;

/// The share of rays that get through, and five standard errors of it.
double share_through(const MilkMedium& milk, const glm::vec3& origin, const glm::vec3& direction,
                     float length) {
    int through = 0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        Sampler sampler(11, i, 0);
        if (milk.free_path(origin, direction, length, sampler) >= length) ++through;
    }
    return static_cast<double>(through) / kRays;
}
double five_errors(double share) {
    return 5.0 * std::sqrt(share * (1.0 - share) / kRays);
}

TEST(MilkMedium, EvenMilkLetsThroughWhatBeersLawSays) {
    const MilkMedium milk(grid::BlockField(tests::even_milk(0.01F)), 3000.0F);
    const glm::vec3 direction = glm::normalize(glm::vec3(0.5F, 0.3F, 0.7F));
    for (const float length : {0.005F, 0.03F, 0.08F}) {
        const double exact = std::exp(-30.0 * static_cast<double>(length));
        EXPECT_NEAR(share_through(milk, {0.02F, 0.03F, 0.01F}, direction, length), exact,
                    five_errors(exact));
        Sampler sampler(1, 2, 3);
        // The least scattering is the most, and what is not yet dark does not go by chance.
        const float even = milk.transmittance({0.02F, 0.03F, 0.01F}, direction, length, sampler);
        if (exact > 0.1) {
            EXPECT_NEAR(even, exact, 1e-5);
        }
    }
}

/// A share that grows evenly along x up to the middle of the last cell.
grid::BoxField growing_milk(int first_cell) {
    grid::BoxField field = tests::even_milk(0.0F, 32);
    for (int k = 0; k < 32; ++k)
        for (int j = 0; j < 32; ++j)
            for (int i = first_cell; i < 32; ++i)
                field.at(i, j, k) = 0.0005F * static_cast<float>(i);
    return field;
}

double share_at(const grid::BoxField& field, float x_m) {
    const float place = std::clamp(x_m / field.shape().cell_m - 0.5F, 0.0F, 31.0F);
    const int below = std::min(static_cast<int>(place), 30);
    const float rest = place - static_cast<float>(below);
    return static_cast<double>(field.at(below, 0, 0) * (1.0F - rest) + field.at(below + 1, 0, 0) * rest);
}

TEST(World, OnTheWayItTellsHowMuchMilkThereWas) {
    Scene scene;
    const grid::BoxField field = growing_milk(0);
    scene.milk_share = grid::BlockField(field);
    const World world(scene);
    const Ray ray{{0.02F, 0.05F, 0.052F}, {1.0F, 0.0F, 0.0F}};
    double difference = 0.0, squares = 0.0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        Sampler sampler(5, i, 0);
        const World::Event event = world.next_event(ray, kLiquid, sampler);
        // The share grows evenly along the way: its integral is that of the middle.
        const double middle = share_at(field, ray.origin.x + 0.5F * event.distance);
        const double apart =
            static_cast<double>(event.milk_m) - middle * static_cast<double>(event.distance);
        difference += apart / kRays;
        squares += apart * apart / kRays;
    }
    EXPECT_LT(std::abs(difference), 5.0 * std::sqrt(squares / kRays));
}

TEST(MilkMedium, MilkEndsACellBeyondItsField) {
    const grid::BoxField field = tests::even_milk(0.01F);
    const MilkMedium milk(grid::BlockField(field), 3000.0F);
    const float size_m = static_cast<float>(field.shape().nx) * field.shape().cell_m;
    const double exact = std::exp(-30.0 * static_cast<double>(0.02F + field.shape().cell_m));
    for (const float length : {1.0F, 1e6F, kFar})
        EXPECT_NEAR(share_through(milk, {size_m - 0.02F, 0.03F, 0.04F}, {1.0F, 0.0F, 0.0F}, length),
                    exact, five_errors(exact))
            << length;
}

TEST(MilkMedium, VaryingMilkLetsThroughTheExponentialOfItsIntegral) {
    const grid::BoxField field = growing_milk(16);
    const MilkMedium milk(grid::BlockField(field), 3000.0F);
    const glm::vec3 origin(0.001F, 0.047F, 0.052F), direction(1.0F, 0.0F, 0.0F);
    const float length = 0.097F;
    double depth = 0.0;
    for (int step = 0; step < 10000; ++step) {
        const float at = (static_cast<float>(step) + 0.5F) / 10000.0F * length;
        depth += 3000.0 * share_at(field, origin.x + at) * static_cast<double>(length) / 10000.0;
    }
    const double exact = std::exp(-depth);
    EXPECT_NEAR(share_through(milk, origin, direction, length), exact, five_errors(exact));
    double sum = 0.0, squares = 0.0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
        Sampler sampler(12, i, 0);
        const auto share = static_cast<double>(milk.transmittance(origin, direction, length, sampler));
        sum += share / kRays;
        squares += share * share / kRays;
    }
    EXPECT_NEAR(sum, exact, 5.0 * std::sqrt((squares - sum * sum) / kRays));
}

/// The milk is asked for in one of the cells around, and its mean is that between them.
TEST(MilkMedium, IsLinearBetweenCentresAndEvenBeyondThem) {
    grid::BoxField field = tests::even_milk(0.0F, 4);
    field.at(1, 2, 3) = 0.4F;
    field.at(2, 2, 3) = 0.2F;
    const MilkMedium milk(grid::BlockField(field), 3000.0F);
    const float h = 0.025F, length = 1e-4F;
    const auto expect_share = [&](const glm::vec3& place, double share) {
        const double exact = std::exp(-3000.0 * share * static_cast<double>(length));
        const glm::vec3 up(0.0F, 0.0F, 1.0F);
        EXPECT_NEAR(share_through(milk, place - 0.5F * length * up, up, length), exact,
                    five_errors(exact));
    };
    expect_share({1.5F * h, 2.5F * h, 3.5F * h}, 0.4);
    expect_share({2.0F * h, 2.5F * h, 3.5F * h}, 0.3);
    expect_share({1.5F * h, 2.5F * h, 3.9F * h}, 0.4);
}

TEST(MilkMedium, TeaWithoutMilkIsEmpty) {
    EXPECT_TRUE(MilkMedium(grid::BlockField(tests::even_milk(0.0F)), 3000.0F).empty());
    EXPECT_TRUE(MilkMedium(grid::BlockField(), 3000.0F).empty());
}

TEST(World, TeaAbsorbsByBeersLaw) {
    const World world((Scene()));
    const glm::vec3 share = world.absorbed(kLiquid, 0.05F);
    EXPECT_NEAR(share.r, std::exp(-4.5 * 0.05), 1e-6);
    EXPECT_NEAR(share.g, std::exp(-17.0 * 0.05), 1e-6);
    EXPECT_NEAR(share.b, std::exp(-48.0 * 0.05), 1e-6);
    EXPECT_EQ(world.absorbed(kAir, 1.0F), glm::vec3(1.0F));
    // Where a liquid reaches into glass there is glass.
    EXPECT_EQ(world.absorbed(kLiquid | kGlass, 0.01F), world.absorbed(kGlass, 0.01F));
}

TEST(World, AShadowRayThroughTeaLosesWhatSurfacesAndTeaTake) {
    Scene scene;
    const World world(scene);
    Sampler sampler(1, 1, 1);
    std::uint64_t rays = 0;
    // Straight up from the axis, through the level alone.
    const glm::vec3 share =
        world.straight_transmittance({{0.05F, 0.05F, 0.048F}, {0, 0, 1}}, kLiquid, sampler, rays);
    const double surface = 1.0 - std::pow(0.335 / 2.335, 2);
    EXPECT_NEAR(share.g, surface * std::exp(-17.0 * 0.04), 1e-5);
    EXPECT_EQ(rays, 2U);
    // Straight down is the table.
    EXPECT_EQ(world.straight_transmittance({{0.05F, 0.05F, 0.048F}, {0, 0, -1}}, kLiquid, sampler, rays),
              glm::vec3(0.0F));
}

}  // namespace
}  // namespace pastoso::trace
