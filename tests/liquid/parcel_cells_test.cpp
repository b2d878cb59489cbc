#include "liquid/tea/parcel_cells.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

const grid::BoxShape kShape{6, 5, 4, 0.01F};

/// Fields that parcels are shared out to.
struct Shared {
    std::array<grid::BoxField, kSharedFields> values = {grid::BoxField(kShape), grid::BoxField(kShape),
                                                        grid::BoxField(kShape), grid::BoxField(kShape)};
    SharedFields fields() { return {&values[0], &values[1], &values[2], &values[3]}; }
    friend bool operator==(const Shared&, const Shared&) = default;
};

/// One parcel's, the same amount to all fields.
grid::BoxField shared_out(Parcel parcel, const grid::BoxField& open, float amount) {
    Shared shared;
    share_out({&parcel, 1}, open, shared.fields(), [&](const Parcel&) {
        return SharedAmounts{amount, amount, amount, amount};
    });
    for (const grid::BoxField& field : shared.values)
        EXPECT_EQ(field, shared.values[0]);
    return shared.values[0];
}

double sum_of(const grid::BoxField& field) {
    return std::accumulate(field.values().begin(), field.values().end(), 0.0);
}

TEST(ParcelCells, InTheMiddleOfACellItGetsAll) {
    const grid::BoxField field =
        shared_out({{0.025F, 0.015F, 0.025F}, 1.0F}, grid::BoxField(kShape, 1.0F), 2.0F);
    // Positions are floats.
    EXPECT_NEAR(field.at(2, 1, 2), 2.0F, 1e-5F);
    EXPECT_NEAR(sum_of(field), 2.0, 1e-6);
}

TEST(ParcelCells, BetweenMiddlesSharesAreTrilinear) {
    const grid::BoxField field =
        shared_out({{0.03F, 0.015F, 0.0275F}, 1.0F}, grid::BoxField(kShape, 1.0F), 1.0F);
    EXPECT_NEAR(field.at(2, 1, 2), 0.375F, 1e-5F);
    EXPECT_NEAR(field.at(3, 1, 2), 0.375F, 1e-5F);
    EXPECT_NEAR(field.at(2, 1, 3), 0.125F, 1e-5F);
    EXPECT_NEAR(field.at(3, 1, 3), 0.125F, 1e-5F);
}

TEST(ParcelCells, ShutCellsGetNothingAndOpenOnesTheirPart) {
    grid::BoxField open(kShape, 1.0F);
    for (int k = 0; k < kShape.nz; ++k)
        for (int j = 0; j < kShape.ny; ++j)
            open.at(3, j, k) = 0.0F;
    const grid::BoxField field = shared_out({{0.03F, 0.015F, 0.025F}, 1.0F}, open, 1.0F);
    EXPECT_NEAR(field.at(2, 1, 2), 1.0F, 1e-5F);
    EXPECT_EQ(field.at(3, 1, 2), 0.0F);
}

TEST(ParcelCells, WhereNoCellIsOpenAParcelIsLeftAsItIs) {
    Parcel parcel{{0.03F, 0.015F, 0.025F}, 1.0F};
    Shared shared;
    share_out({&parcel, 1}, grid::BoxField(kShape), shared.fields(), [](Parcel& given) {
        given.volume_m3 = 0.0F;
        return SharedAmounts{1.0F, 1.0F, 1.0F, 1.0F};
    });
    EXPECT_EQ(parcel.volume_m3, 1.0F);
    EXPECT_EQ(shared, Shared());
}

/// By lot everywhere.
std::vector<Parcel> scattered(int count) {
    std::vector<Parcel> parcels;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
        parcels.push_back({{0.06F * core::uniform_noise(i, 1), 0.05F * core::uniform_noise(i, 2),
                            0.04F * core::uniform_noise(i, 3)},
                           1.0F,
                           core::uniform_noise(i, 4),
                           static_cast<int>(i)});
    return parcels;
}

SharedAmounts some_amounts(const Parcel& parcel) {
    return {1.0F, parcel.coldness, 2.0F * parcel.coldness, 0.0F};
}

TEST(ParcelCells, AllParcelsAreSharedOutAlikeOnAnyNumberOfThreads) {
    std::vector<Parcel> parcels = scattered(3000);
    const grid::BoxField open(kShape, 1.0F);
    core::ThreadPool one_thread(1);
    ParcelSorter(kShape).sort(parcels, one_thread);
    Shared first;
    share_out_sorted(parcels, open, first.fields(), one_thread, some_amounts);
    for (const int threads : {2, 3}) {
        core::ThreadPool pool(threads);
        Shared shared;
        share_out_sorted(parcels, open, shared.fields(), pool, some_amounts);
        EXPECT_EQ(shared, first);
    }
    const double amount = std::accumulate(
        parcels.begin(), parcels.end(), 0.0,
        [](double sum, const Parcel& parcel) { return sum + static_cast<double>(parcel.coldness); });
    // Rounding of 3000 floats.
    EXPECT_NEAR(sum_of(first.values[0]), 3000.0, 3e-3);
    EXPECT_NEAR(sum_of(first.values[1]), amount, 3e-3);
    EXPECT_NEAR(sum_of(first.values[2]), 2.0 * amount, 6e-3);
}

TEST(ParcelCells, SharesDoNotDependOnTheParcelsOrderButForRounding) {
    std::vector<Parcel> parcels = scattered(500);
    const grid::BoxField open(kShape, 1.0F);
    Shared one_by_one, sorted;
    share_out(parcels, open, one_by_one.fields(), some_amounts);
    core::ThreadPool pool(2);
    ParcelSorter(kShape).sort(parcels, pool);
    share_out_sorted(parcels, open, sorted.fields(), pool, some_amounts);
    for (std::size_t f = 0; f < kSharedFields; ++f)
        for (std::size_t n = 0; n < kShape.sample_count(); ++n)
            // Sums of some dozens of shares.
            ASSERT_NEAR(one_by_one.values[f].values()[n], sorted.values[f].values()[n], 1e-5F);
}

TEST(ParcelCells, WhatHasGoneChangesNoBitOfTheRest) {
    std::vector<Parcel> parcels = scattered(2000);
    core::ThreadPool pool(2);
    ParcelSorter(kShape).sort(parcels, pool);
    for (std::size_t i = 0; i < parcels.size(); i += 3)
        parcels[i].volume_m3 = 0.0F;
    const auto volume = [](const Parcel& parcel) {
        return SharedAmounts{parcel.volume_m3, 0.0F, 0.0F, parcel.volume_m3 * parcel.coldness};
    };
    Shared with_gone, without;
    const grid::BoxField open(kShape, 1.0F);
    share_out_sorted(parcels, open, with_gone.fields(), pool, volume);
    std::erase_if(parcels, [](const Parcel& parcel) { return parcel.volume_m3 == 0.0F; });
    share_out_sorted(parcels, open, without.fields(), pool, volume);
    EXPECT_EQ(with_gone, without);
}

TEST(ParcelCells, SortedParcelsAreThoseThereWereByTheCellsAroundThem) {
    // More than a block of the sorter.
    std::vector<Parcel> parcels = scattered(9000);
    const std::vector<Parcel> before = parcels;
    std::vector<Parcel> on_three = parcels;
    core::ThreadPool one(1), three(3);
    ParcelSorter(kShape).sort(parcels, one);
    ParcelSorter(kShape).sort(on_three, three);
    EXPECT_EQ(parcels, on_three);
    const auto cell_of = [](const Parcel& parcel) {
        const glm::vec3 at = parcel.position_m / kShape.cell_m;
        return kShape.index(between_middles(at.x).lower, between_middles(at.y).lower,
                            between_middles(at.z).lower);
    };
    for (std::size_t i = 1; i < parcels.size(); ++i) {
        ASSERT_LE(cell_of(parcels[i - 1]), cell_of(parcels[i]));
        if (cell_of(parcels[i - 1]) == cell_of(parcels[i])) {
            ASSERT_LT(parcels[i - 1].ball, parcels[i].ball);
        }
    }
    std::sort(parcels.begin(), parcels.end(),
              [](const Parcel& a, const Parcel& b) { return a.ball < b.ball; });
    EXPECT_EQ(parcels, before);
}

TEST(ParcelCells, BetweenIsTheFloor) {
    for (const float place : {-2.0F, -1.5F, -1.0F, -0.25F, 0.0F, 0.25F, 1.0F, 2.75F}) {
        const Between found = between(place);
        EXPECT_EQ(static_cast<float>(found.lower), std::floor(place));
        EXPECT_EQ(found.part, place - std::floor(place));
    }
}

TEST(ParcelCellsDeathTest, APositionThatIsNoNumberIsFoundAtOnce) {
    std::vector<Parcel> parcels = {{{0.0F / 0.0F, 0.015F, 0.025F}, 1.0F}};
    core::ThreadPool pool(1);
    EXPECT_DEATH(ParcelSorter(kShape).sort(parcels, pool), "broken invariant");
}

}  // namespace
}  // namespace pastoso::liquid
