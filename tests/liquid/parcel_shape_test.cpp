#include "liquid/tea/parcel_shape.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr ShapeLimits kFree = {.most = 1e3F, .widening_per_strain = 0.0F};

glm::mat3 diagonal(float x, float y, float z) {
    return {x, 0, 0, 0, y, 0, 0, 0, z};
}

void expect_near(const ParcelShape& a, const ParcelShape& b, float tolerance) {
    for (const auto value : {&ParcelShape::xx, &ParcelShape::yy, &ParcelShape::zz, &ParcelShape::xy,
                             &ParcelShape::xz, &ParcelShape::yz})
        EXPECT_NEAR(a.*value, b.*value, tolerance);
}

TEST(ParcelShape, AParcelThatIsDrawnOutBecomesThinAndKeepsItsVolume) {
    ParcelShape shape;
    for (int n = 0; n < 100; ++n)
        shape = deformed(shape, diagonal(0.01F, -0.005F, -0.005F), kFree);
    // Along the axis e^1 times as long; the steps are of first order.
    EXPECT_NEAR(shape.xx, std::exp(2.0F), 0.06F);
    EXPECT_NEAR(shape.yy, std::exp(-1.0F), 0.01F);
    EXPECT_EQ(shape.yy, shape.zz);
    EXPECT_NEAR(width(shape), 1.0F, 1e-5F);
}

TEST(ParcelShape, ARotationLeavesARoundParcelAndTurnsALongOne) {
    ParcelShape round, drawn = {.xx = 4.0F, .yy = 0.5F, .zz = 0.5F};
    const float quarter = 1.57079633F;
    for (int n = 0; n < 1000; ++n) {
        const float angle = quarter / 1000.0F;
        const glm::mat3 turn(0, angle, 0, -angle, 0, 0, 0, 0, 0);
        round = deformed(round, turn, {.most = 9.0F, .widening_per_strain = 5.0F});
        drawn = deformed(drawn, turn, {.most = 9.0F, .widening_per_strain = 5.0F});
    }
    expect_near(round, {}, 2e-3F);
    expect_near(drawn, {.xx = 0.5F, .yy = 4.0F, .zz = 0.5F}, 2e-2F);
}

TEST(ParcelShape, ItWidensByTheStrainUpToTheLimit) {
    const ShapeLimits limits = {.most = 9.0F, .widening_per_strain = 0.1F};
    ParcelShape shape;
    // A shear of 0.2: |L| dt = 0.2.
    const glm::mat3 shear(0, 0, 0, 0.2F, 0, 0, 0, 0, 0);
    for (int n = 1; n <= 50; ++n) {
        shape = deformed(shape, shear, limits);
        EXPECT_NEAR(width(shape), 1.0F + 0.02F * static_cast<float>(n), 1e-4F);
    }
    for (int n = 0; n < 1000; ++n)
        shape = deformed(shape, shear, limits);
    EXPECT_NEAR(width(shape), 9.0F, 1e-4F);
}

TEST(ParcelShape, NoAxisGrowsMuchBeyondTheLimitWhateverFlows) {
    const ShapeLimits limits = {.most = 9.0F, .widening_per_strain = 0.02F};
    ParcelShape shape;
    float longest = 0.0F;
    for (std::uint32_t n = 0; n < 2000; ++n) {
        glm::mat3 strain;
        for (int e = 0; e < 9; ++e)
            strain[e / 3][e % 3] =
                2.0F * core::uniform_noise(9 * n + static_cast<std::uint32_t>(e), 4) - 1.0F;
        shape = deformed(shape, strain, limits);
        ASSERT_TRUE(is_shape(shape)) << n;
        for (const float square : {shape.xx, shape.yy, shape.zz})
            longest = std::max(longest, square);
    }
    // What an axis loses goes to all, itself among them.
    EXPECT_LE(longest, 2.0F * limits.most);
}

TEST(ParcelShape, ComesFromTheVelocitysGradientInTheCell) {
    const grid::BoxShape box{8, 8, 8, 0.01F};
    const glm::mat3 gradient_per_s(0.1F, 0.2F, -0.3F, 0.4F, 0.1F, 0.5F, -0.1F, 0.3F, -0.2F);
    VelocityField velocity(box);
    for (const int axis : kAxes)
        for (int k = -1; k <= 9; ++k)
            for (int j = -1; j <= 9; ++j)
                for (int i = -1; i <= 9; ++i) {
                    const glm::vec3 at_m =
                        box.cell_m * (glm::vec3(i, j, k) + offset_cells(face_across(axis)));
                    velocity.along(axis).at(i, j, k) = (gradient_per_s * at_m)[axis];
                }
    std::vector<Parcel> parcels = {{.position_m = glm::vec3(0.031F, 0.047F, 0.002F)},
                                   {.position_m = glm::vec3(0.079F, 0.001F, 0.044F)}};
    constexpr ShapeLimits kLimits = {.most = 9.0F, .widening_per_strain = 0.3F};
    deform(parcels, velocity, 0.25F, kLimits);
    for (const Parcel& parcel : parcels)
        expect_near(parcel.shape, deformed({}, 0.25F * gradient_per_s, kLimits), 1e-5F);
}

/// -1 to 1, by lot.
float by_lot(std::uint32_t number, std::uint32_t seed) {
    return 2.0F * core::uniform_noise(number, seed) - 1.0F;
}

VelocityField random_velocity(const grid::BoxShape& box) {
    VelocityField velocity(box);
    for (const int axis : kAxes) {
        std::uint32_t n = 0;
        for (float& value : velocity.along(axis).values())
            value = 0.003F * by_lot(n++, static_cast<std::uint32_t>(axis));
    }
    return velocity;
}

/// Anywhere in the box and a little beyond it; round, drawn out, and nearly flat.
std::vector<Parcel> random_parcels(const grid::BoxShape& box, std::uint32_t count) {
    const glm::vec3 size_m = box.cell_m * glm::vec3(box.nx, box.ny, box.nz);
    std::vector<Parcel> parcels(count);
    for (std::uint32_t n = 0; n < count; ++n) {
        Parcel& parcel = parcels[n];
        const glm::vec3 share(by_lot(n, 10), by_lot(n, 11), by_lot(n, 12));
        parcel = {(0.5F + 0.51F * share) * size_m, by_lot(n, 13), by_lot(n, 14), static_cast<int>(n)};
        if (n % 3 == 0) continue;
        parcel.shape = {.xx = 5.0F + 4.0F * by_lot(n, 15),
                        .yy = 2.0F + by_lot(n, 16),
                        .zz = n % 3 == 1 ? 1.0F : 1e-6F,
                        .xy = by_lot(n, 17) * 0.9F,
                        .xz = by_lot(n, 18) * 0.05F};
    }
    return parcels;
}

glm::mat3 gradient_per_s(const VelocityField& velocity, const glm::ivec3& cell) {
    glm::mat3 gradient;
    for (const int across : kAxes)
        for (const int along : kAxes) {
            const auto face = [&](int next, int step) {
                glm::ivec3 at = cell;
                at[across] += next;
                at[along] += step;
                return velocity.along(across).at(at.x, at.y, at.z);
            };
            const float change = along == across
                                     ? face(1, 0) - face(0, 0)
                                     : 0.25F * (face(0, 1) + face(1, 1) - face(0, -1) - face(1, -1));
            gradient[along][across] = change / velocity.shape().cell_m;
        }
    return gradient;
}

bool is_round(const ParcelShape& s) {
    return s == ParcelShape{s.xx, s.xx, s.xx};
}

/// One by one.
std::vector<Parcel> each_deformed(std::vector<Parcel> parcels, const VelocityField& velocity, float dt_s,
                                  const ShapeLimits& limits) {
    const grid::BoxShape& box = velocity.shape();
    for (Parcel& parcel : parcels) {
        const glm::ivec3 cell = glm::clamp(glm::ivec3(parcel.position_m / box.cell_m), glm::ivec3(0),
                                           glm::ivec3(box.nx, box.ny, box.nz) - 1);
        parcel.shape = deformed(parcel.shape, dt_s * gradient_per_s(velocity, cell), limits);
    }
    return parcels;
}

/// To the bit: 0 and -0 are not the same.
bool same_bits(const std::vector<Parcel>& a, const std::vector<Parcel>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Parcel)) == 0);
}

TEST(ParcelShape, ManyAreDeformedAsEachAloneIsOnEveryInstructionSet) {
    const grid::BoxShape box{7, 6, 5, 0.01F};
    const VelocityField velocity = random_velocity(box);
    constexpr float kTime_s = 1.5F;
    for (const float widening : {0.05F, 1e-6F})
        for (const std::uint32_t count : {0U, 1U, 3U, 8U, 15U, 16U, 33U, 255U, 257U, 1000U}) {
            const ShapeLimits limits = {.most = 6.0F, .widening_per_strain = widening};
            const std::vector<Parcel> parcels = random_parcels(box, count);
            const std::vector<Parcel> expected = each_deformed(parcels, velocity, kTime_s, limits);
            for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
                if (isa > core::best_isa()) continue;
                std::vector<Parcel> together = parcels;
                deform(together, velocity, kTime_s, limits, core::kernels<DeformationKernels>(isa));
                EXPECT_TRUE(same_bits(together, expected)) << count << " on " << core::name_of(isa);
            }
        }
}

TEST(ParcelShape, OfThoseByLotManyAreDrawnOutAndManyTorn) {
    const grid::BoxShape box{7, 6, 5, 0.01F};
    const std::vector<Parcel> parcels =
        each_deformed(random_parcels(box, 1000), random_velocity(box), 1.5F,
                      {.most = 6.0F, .widening_per_strain = 1e-6F});
    const auto torn =
        std::ranges::count_if(parcels, [](const Parcel& parcel) { return is_round(parcel.shape); });
    EXPECT_GT(torn, 100);
    EXPECT_LT(torn, 900);
}

TEST(ParcelShape, LimitsAreThoseOfTheCellAndOfTheParcel) {
    TeaSettings settings;
    const float cells =
        3.0F * static_cast<float>(settings.box_m / settings.cells) / poured_reach_m(settings);
    EXPECT_NEAR(shape_limits(settings).most, 1.0F + cells * cells / 3.0F, 1e-4F);
    settings.parcels = 1'000'000;
    EXPECT_EQ(shape_limits(settings).most, 16.0F);
}

TEST(ParcelShape, WhatIsNotPositiveDefiniteIsNone) {
    EXPECT_TRUE(is_shape({}));
    EXPECT_FALSE(is_shape({.xx = -1.0F}));
    EXPECT_FALSE(is_shape({.xy = 1.5F}));
    EXPECT_FALSE(is_shape({.xy = 0.8F, .xz = 0.8F, .yz = -0.8F}));
    EXPECT_FALSE(is_shape({.yz = std::numeric_limits<float>::quiet_NaN()}));
    EXPECT_FALSE(is_shape({.xx = std::numeric_limits<float>::infinity()}));
}

}  // namespace
}  // namespace pastoso::liquid
