#include "liquid/surface/metaballs.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr float kUnitVolume = 26e-6F / 12000.0F;

/// A cloud of parcels of different sizes around the middle of a box of 0.1 m.
std::vector<Parcel> cloud(int count, std::uint32_t seed, float width_m = 0.08F) {
    std::uint32_t index = 0;
    const auto share = [&] { return core::uniform_noise(index++, seed); };
    std::vector<Parcel> parcels;
    for (int n = 0; n < count; ++n) {
        Parcel parcel;
        for (int axis = 0; axis < 3; ++axis) {
            const float middle = (share() + share() + share()) / 3.0F - 0.5F;
            parcel.position_m[axis] = 0.05F + middle * width_m;
        }
        parcel.volume_m3 = kUnitVolume * (0.2F + 0.8F * share());
        parcels.push_back(parcel);
    }
    return parcels;
}

Lattice lattice_of(int n) {
    return cell_centres({n, n, n, 0.1F / static_cast<float>(n)});
}

/// By the definition, for a ball of the size of the unit volume's: `size` times that.
double kernel_value(const CompactBalls& balls, double size, double r_m) {
    const double reach_m =
        std::max(static_cast<double>(balls.radius_m) * size, static_cast<double>(balls.least_radius_m));
    const double u = std::max(0.0, 1.0 - r_m * r_m / (reach_m * reach_m));
    return u * u * u;
}
double kernel_value(const InverseSquareBalls& balls, double size, double r_m) {
    const double a_m = static_cast<double>(balls.a_m) * size;
    return 0.003 * a_m * a_m / (r_m * r_m);
}

/// The sum at one point in double precision, one ball after the other.
double metaball_sum(const std::vector<Parcel>& parcels, const Metaballs& balls,
                    const glm::vec3& point_m) {
    double sum = 0.0;
    for (const Parcel& parcel : parcels) {
        const double r_m = glm::length(glm::dvec3(point_m) - glm::dvec3(parcel.position_m));
        const double size =
            std::cbrt(static_cast<double>(parcel.volume_m3) / static_cast<double>(balls.unit_volume_m3));
        sum += std::visit([&](const auto& kernel) { return kernel_value(kernel, size, r_m); },
                          balls.kernel);
    }
    return sum;
}

/// The largest error of samples relative to the greater of the sum there and `floor`.
double largest_error(const SampledField& field, const std::vector<Parcel>& parcels,
                     const Metaballs& balls, double floor, int step = 1) {
    const Lattice& lattice = field.lattice();
    double largest = 0.0;
    int number = 0;
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                if (number++ % step != 0) continue;
                const double exact = metaball_sum(parcels, balls, lattice.point_m(i, j, k));
                const double error = std::abs(static_cast<double>(field.at(i, j, k)) - exact);
                largest = std::max(largest, error / std::max(exact, floor));
            }
    return largest;
}

TEST(Metaballs, ABallAloneHasItsKernel) {
    core::ThreadPool pool(1);
    // Twice the size of a parcel of the unit volume, on a sample; the others are a millimetre apart.
    const std::vector<Parcel> parcels = {{{0.0F, 0.0F, 0.0F}, 8.0F * kUnitVolume, 1.0F, -1}};
    const auto at = [&](const BallKernel& kernel, int x_mm) {
        SampledField field(Lattice{24, 3, 3, 0.001F, {0.0F, 0.0F, 0.0F}});
        MetaballField(pool).fill(parcels, {kernel, kUnitVolume}, field);
        return field.at(x_mm, 0, 0);
    };
    EXPECT_NEAR(at(CompactBalls{0.001F, 0.0F}, 1), std::pow(0.75, 3.0), 1e-6);
    EXPECT_EQ(at(CompactBalls{0.001F, 0.0F}, 2), 0.0F);
    EXPECT_NEAR(at(CompactBalls{0.001F, 0.004F}, 2), std::pow(0.75, 3.0), 1e-6);
    EXPECT_NEAR(at(InverseSquareBalls{0.1F}, 5), 0.003 * 0.04 / 0.000025, 1e-3);
    EXPECT_NEAR(at(InverseSquareBalls{0.1F}, 20), 0.003 * 0.04 / 0.0004, 1e-4);
}

TEST(Metaballs, BallsThatEndAreAddedAsTheSumSays) {
    core::ThreadPool pool(1);
    // Some beyond the lattice, too.
    const std::vector<Parcel> parcels = cloud(400, 1, 0.13F);
    SampledField field(lattice_of(33));
    const Metaballs balls{CompactBalls{0.006F, 0.005F}, kUnitVolume};
    MetaballField(pool).fill(parcels, balls, field);
    // Floats of places in units of a spacing: 33 * 6e-8 on a slope of about 1 a spacing; sums of up to
    // ten.
    EXPECT_LT(largest_error(field, parcels, balls, 1.0), 1e-5);
}

TEST(Metaballs, BallsWithoutEndAreSummedInFull) {
    core::ThreadPool pool(1);
    const std::vector<Parcel> parcels = cloud(500, 2);
    SampledField field(lattice_of(40));
    const Metaballs balls{InverseSquareBalls{}, kUnitVolume};
    MetaballField sum(pool);
    for (int run = 0; run < 2; ++run) {  // the second time in memory that is used already
        sum.fill(parcels, balls, field);
        EXPECT_LT(largest_error(field, parcels, balls, 0.0, 7), 1e-4);
    }
}

TEST(Metaballs, TheLatticeNeedNotBeACubeNorHoldAllBalls) {
    core::ThreadPool pool(1);
    const std::vector<Parcel> parcels = cloud(200, 3, 0.2F);
    const Metaballs balls{InverseSquareBalls{}, kUnitVolume};
    SampledField field(Lattice{21, 30, 13, 0.003F, {0.02F, 0.01F, 0.03F}});
    MetaballField(pool).fill(parcels, balls, field);
    EXPECT_LT(largest_error(field, parcels, balls, 0.0, 5), 1e-4);
}

TEST(Metaballs, ParcelsWithoutVolumeCountNothing) {
    core::ThreadPool pool(1);
    std::vector<Parcel> parcels = cloud(3, 4);
    for (Parcel& parcel : parcels)
        parcel.volume_m3 = 0.0F;
    SampledField field(lattice_of(16), 5.0F);
    MetaballField(pool).fill(parcels, {}, field);
    for (int i = 0; i < 16; ++i)
        EXPECT_EQ(field.at(i, 8, 8), 0.0F);
}

TEST(MetaballsThreads, GiveTheSameBitsWithEveryInstructionSet) {
    const std::vector<Parcel> parcels = cloud(300, 5);
    core::ThreadPool one(1), three(3);
    for (const BallKernel& kernel :
         {BallKernel(CompactBalls{0.005F, 0.004F}), BallKernel(InverseSquareBalls{})}) {
        const Metaballs balls{kernel, kUnitVolume};
        SampledField expected(lattice_of(30)), field(lattice_of(30));
        MetaballField(one).fill(parcels, balls, expected, core::Isa::Baseline);
        for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
            if (isa > core::best_isa()) continue;
            MetaballField(three).fill(parcels, balls, field, isa);
            bool same = true;
            for (int k = 0; k < 30; ++k)
                for (int j = 0; j < 30; ++j)
                    same = same && std::equal(field.row(j, k), field.row(j, k) + 30, expected.row(j, k));
            EXPECT_TRUE(same) << kernel.index() << " " << core::name_of(isa);
        }
    }
}

}  // namespace
}  // namespace pastoso::liquid
