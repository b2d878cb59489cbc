#include "liquid/tea/milk_density.hpp"

#include "core/random.hpp"
#include "liquid/tea/parcel_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr grid::BoxShape kFlow{32, 32, 32, 0.1F / 32.0F};
constexpr float kVolume = 26e-6F / 40000.0F;

/// Drawn out three times, each time in another direction.
ParcelShape drawn_out(std::uint32_t number, std::uint32_t seed, const ShapeLimits& limits) {
    ParcelShape shape;
    for (std::uint32_t time = 0; time < 3; ++time) {
        glm::mat3 strain;
        for (int n = 0; n < 9; ++n)
            strain[n / 3][n % 3] =
                core::uniform_noise(9 * time + static_cast<std::uint32_t>(n), seed + number) - 0.5F;
        shape = deformed(shape, strain, limits);
    }
    return shape;
}

/// By lot everywhere in the tea, as near to its wall as parcels come.
std::vector<Parcel> scattered(int count, std::uint32_t seed,
                              const ShapeLimits& limits = {.most = 9.0F, .widening_per_strain = 1.0F}) {
    std::vector<Parcel> parcels;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
        const auto drawn = [&](std::uint32_t stream) { return core::uniform_noise(i, seed + stream); };
        const glm::vec3 at_m(0.1F * drawn(0), 0.1F * drawn(1), 0.1F * drawn(2));
        parcels.push_back({brought_within({}, at_m, 0.3F * kFlow.cell_m), kVolume * drawn(3), 1.0F, -1,
                           drawn_out(i, seed, limits)});
    }
    return parcels;
}

/// Milk that has dissolved in the cells whose middles lie in the tea, thicker below.
grid::BoxField dissolved_milk() {
    grid::BoxField field(kFlow);
    for (int k = 0; k < kFlow.nz; ++k)
        for (int j = 0; j < kFlow.ny; ++j)
            for (int i = 0; i < kFlow.nx; ++i) {
                const glm::vec3 middle_m = (glm::vec3(i, j, k) + 0.5F) * kFlow.cell_m;
                if (tea_distance_m({}, middle_m) < 0.0F)
                    field.at(i, j, k) = 0.01F * static_cast<float>(32 - k + i % 3);
            }
    return field;
}

double sum_m3(const grid::BlockField& density) {
    const grid::BoxShape& shape = density.shape();
    double sum = 0.0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                sum += static_cast<double>(density.at(i, j, k));
    return sum * shape.cell_volume_m3();
}

double milk_m3(std::span<const Parcel> parcels, const grid::BoxField& dissolved) {
    double sum = 0.0;
    for (const float share : dissolved.values())
        sum += static_cast<double>(share) * kFlow.cell_volume_m3();
    for (const Parcel& parcel : parcels)
        sum += static_cast<double>(parcel.volume_m3);
    return sum;
}

TEST(MilkDensity, HoldsAllMilkOnEveryLattice) {
    core::ThreadPool pool(2);
    MilkDensities densities(pool);
    const std::vector<Parcel> parcels = scattered(20000, 5);
    const grid::BoxField dissolved = dissolved_milk();
    for (const int cells : {32, 50, 96, 200}) {
        for (const float reach_m : {0.0007F, 0.003F}) {
            SCOPED_TRACE(::testing::Message() << cells << " cells, reach " << reach_m);
            const MilkDensitySettings settings{cells, reach_m};
            for (const grid::BoxField& mixed : {grid::BoxField(kFlow), dissolved}) {
                const double milk = milk_m3(parcels, mixed);
                EXPECT_NEAR(sum_m3(densities.make(parcels, mixed, {}, settings)), milk, 1e-6 * milk);
            }
        }
    }
}

/// rho as milk_density.hpp has it of narrow parcels, for every cell and parcel.
double density_by_definition(std::span<const Parcel> parcels, const grid::BoxShape& shape,
                             double reach_m, const glm::ivec3& cell) {
    const auto kernel = [&](const Parcel& parcel, const glm::ivec3& at) {
        const glm::dvec3 middle_m = (glm::dvec3(at) + 0.5) * static_cast<double>(shape.cell_m);
        const glm::dvec3 apart_m = middle_m - glm::dvec3(parcel.position_m);
        const ParcelShape& s = parcel.shape;
        const glm::dmat3 drawn(s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz);
        const double cell_m = static_cast<double>(shape.cell_m);
        const glm::dmat3 ellipsoid = reach_m * reach_m * drawn + glm::dmat3(0.5 * cell_m * cell_m);
        const double left = 1.0 - glm::dot(apart_m, glm::inverse(ellipsoid) * apart_m);
        const bool is_in_tea = tea_distance_m({}, glm::vec3(middle_m)) <= 0.0F;
        return left > 0.0 && is_in_tea ? left * left : 0.0;
    };
    double share = 0.0;
    for (const Parcel& parcel : parcels) {
        if (kernel(parcel, cell) == 0.0) continue;
        double sum = 0.0;
        const glm::ivec3 middle(parcel.position_m / shape.cell_m);
        for (int z = -9; z <= 9; ++z)
            for (int y = -9; y <= 9; ++y)
                for (int x = -9; x <= 9; ++x)
                    sum += kernel(parcel, middle + glm::ivec3(x, y, z));
        share +=
            static_cast<double>(parcel.volume_m3) / shape.cell_volume_m3() * kernel(parcel, cell) / sum;
    }
    return share;
}

TEST(MilkDensity, IsTheSumOfKernelsThatItsDefinitionSays) {
    core::ThreadPool pool(2);
    MilkDensities densities(pool);
    const std::vector<Parcel> parcels = scattered(300, 77, {.most = 9.0F, .widening_per_strain = 0.0F});
    constexpr float kReach_m = 0.0045F;
    const grid::BlockField density = densities.make(parcels, grid::BoxField(kFlow), {}, {60, kReach_m});
    const grid::BoxShape& shape = density.shape();
    for (std::uint32_t i = 0; i < 300; ++i) {
        const glm::vec3 near_m = parcels[i].position_m + glm::vec3(0.001F, -0.0012F, 0.0008F);
        const glm::ivec3 cell(near_m / shape.cell_m);
        // Kernels and sums in single precision.
        EXPECT_NEAR(density.at(cell.x, cell.y, cell.z),
                    density_by_definition(parcels, shape, kReach_m, cell), 1e-5);
    }
}

TEST(MilkDensity, OfWideParcelsIsThatOfDissolvedMilk) {
    core::ThreadPool pool(2);
    MilkDensities densities(pool);
    constexpr float kShare = 0.3F;
    const auto volume_m3 = static_cast<float>(kShare * kFlow.cell_volume_m3());
    const ParcelShape wide = {20.0F, 20.0F, 20.0F};
    grid::BoxField none(kFlow), dissolved(kFlow);
    dissolved.at(15, 17, 12) = 0.75F * kShare;
    dissolved.at(16, 17, 12) = 0.25F * kShare;
    const Parcel parcel = {glm::vec3(15.75F, 17.5F, 12.5F) * kFlow.cell_m, volume_m3, 1.0F, -1, wide};
    const MilkDensitySettings settings{96, 0.002F};
    const grid::BlockField of_parcel = densities.make(std::array{parcel}, none, {}, settings);
    const grid::BlockField of_dissolved = densities.make({}, dissolved, {}, settings);
    ASSERT_EQ(of_parcel.samples().size(), of_dissolved.samples().size());
    for (std::size_t n = 0; n < of_parcel.samples().size(); ++n)
        ASSERT_NEAR(of_parcel.samples()[n], of_dissolved.samples()[n], 1e-6F);
}

TEST(MilkDensity, IsTheSameOnAnyNumberOfThreads) {
    const std::vector<Parcel> parcels = scattered(5000, 9);
    const grid::BoxField dissolved = dissolved_milk();
    core::ThreadPool one(1), three(3);
    const grid::BlockField a = MilkDensities(one).make(parcels, dissolved, {}, {100, 0.002F});
    MilkDensities again(three);
    again.make(parcels, grid::BoxField(kFlow), {}, {64, 0.002F});
    const grid::BlockField b = again.make(parcels, dissolved, {}, {100, 0.002F});
    EXPECT_EQ(a.samples(), b.samples());
}

TEST(MilkDensity, IsMirroredWithItsParcels) {
    core::ThreadPool pool(1);
    MilkDensities densities(pool);
    std::vector<Parcel> parcels = scattered(2000, 3);
    const grid::BoxField none(kFlow);
    const MilkDensitySettings settings{80, 0.002F};
    const grid::BlockField density = densities.make(parcels, none, {}, settings);
    for (Parcel& parcel : parcels) {
        parcel.position_m.x = 0.1F - parcel.position_m.x;
        parcel.shape.xy = -parcel.shape.xy;
        parcel.shape.xz = -parcel.shape.xz;
    }
    const grid::BlockField mirrored = densities.make(parcels, none, {}, settings);
    for (int k = 0; k < 80; ++k)
        for (int j = 0; j < 80; ++j)
            for (int i = 0; i < 80; ++i)
                // The mirrored places themselves are rounded.
                ASSERT_NEAR(density.at(i, j, k), mirrored.at(79 - i, j, k), 2e-4);
}

TEST(MilkDensity, PutsNothingIntoTheGlass) {
    core::ThreadPool pool(1);
    MilkDensities densities(pool);
    const grid::BlockField density =
        densities.make(scattered(5000, 21), dissolved_milk(), {}, {120, 0.002F});
    const float cell_m = density.shape().cell_m;
    for (int k = 0; k < 120; ++k)
        for (int j = 0; j < 120; ++j)
            for (int i = 0; i < 120; ++i) {
                if (density.at(i, j, k) <= 0.0F) continue;
                const glm::vec3 middle_m = (glm::vec3(i, j, k) + 0.5F) * cell_m;
                ASSERT_LE(tea_distance_m({}, middle_m), 1e-6F);
            }
}

TEST(MilkDensity, EvenMilkIsEven) {
    core::ThreadPool pool(1);
    MilkDensities densities(pool);
    std::vector<Parcel> parcels;
    const float step_m = std::cbrt(kVolume);
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
                parcels.push_back({glm::vec3(0.045F) + step_m * glm::vec3(i, j, k), kVolume, 1.0F, -1});
    TeaSettings settings;
    settings.parcels = 40000;
    const grid::BlockField density =
        densities.make(parcels, grid::BoxField(kFlow), {}, even_density(settings));
    const float cell_m = density.shape().cell_m;
    for (int n = 0; n < 300; ++n) {
        const auto drawn = [&](std::uint32_t axis) {
            return core::uniform_noise(static_cast<std::uint32_t>(n), axis);
        };
        const glm::vec3 at_m = 0.045F + step_m * (4.0F + 7.0F * glm::vec3(drawn(1), drawn(2), drawn(3)));
        // Of a lattice, whose gaps are even, the kernel leaves a few percent of ripples.
        EXPECT_NEAR(density.between(at_m / cell_m), 1.0F, 0.08F);
    }
}

}  // namespace
}  // namespace pastoso::liquid
