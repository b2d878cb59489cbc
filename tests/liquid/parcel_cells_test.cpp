#include "liquid/tea/parcel_cells.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

const grid::BoxShape kShape{6, 5, 4, 0.01F};

std::vector<ParcelShares> shares_of(const Parcel& parcel, const grid::BoxField& open) {
    core::ThreadPool pool(1);
    std::vector<ParcelShares> shares;
    compute_shares({&parcel, 1}, open, pool, shares);
    return shares;
}

/// Into `field`.
void scatter_one(const Parcel& parcel, const grid::BoxField& open, float amount, grid::BoxField& field) {
    core::ThreadPool pool(1);
    grid::BoxField twice(kShape);
    scatter(shares_of(parcel, open), {{{&amount, 1}, {&amount, 1}}}, {&field, &twice}, pool);
    EXPECT_EQ(field, twice);
}

double sum_of(const grid::BoxField& field) {
    return std::accumulate(field.values().begin(), field.values().end(), 0.0);
}

TEST(ParcelCells, InTheMiddleOfACellItGetsAll) {
    const Parcel parcel{{0.025F, 0.015F, 0.025F}, 1.0F};
    grid::BoxField field(kShape);
    scatter_one(parcel, grid::BoxField(kShape, 1.0F), 2.0F, field);
    // Positions are floats.
    EXPECT_NEAR(field.at(2, 1, 2), 2.0F, 1e-5F);
    EXPECT_NEAR(sum_of(field), 2.0, 1e-6);
}

TEST(ParcelCells, BetweenMiddlesSharesAreTrilinear) {
    const Parcel parcel{{0.03F, 0.015F, 0.0275F}, 1.0F};
    grid::BoxField field(kShape);
    scatter_one(parcel, grid::BoxField(kShape, 1.0F), 1.0F, field);
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
    const Parcel parcel{{0.03F, 0.015F, 0.025F}, 1.0F};
    grid::BoxField field(kShape);
    scatter_one(parcel, open, 1.0F, field);
    EXPECT_NEAR(field.at(2, 1, 2), 1.0F, 1e-5F);
    EXPECT_EQ(field.at(3, 1, 2), 0.0F);
}

TEST(ParcelCells, WhereNoCellIsOpenThereAreNoShares) {
    const Parcel parcel{{0.03F, 0.015F, 0.025F}, 1.0F};
    EXPECT_FALSE(shares_of(parcel, grid::BoxField(kShape)).front().any());
}

/// By lot everywhere.
std::vector<Parcel> scattered(int count) {
    std::vector<Parcel> parcels;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
        parcels.push_back({{0.06F * core::uniform_noise(i, 1), 0.05F * core::uniform_noise(i, 2),
                            0.04F * core::uniform_noise(i, 3)},
                           1.0F,
                           core::uniform_noise(i, 4)});
    return parcels;
}

TEST(ParcelCells, AllParcelsAreScatteredAlikeOnAnyNumberOfThreads) {
    const std::vector<Parcel> parcels = scattered(3000);
    const grid::BoxField open(kShape, 1.0F);
    std::vector<ParcelShares> shares;
    std::vector<float> ones(parcels.size(), 1.0F), amounts;
    for (const Parcel& parcel : parcels)
        amounts.push_back(parcel.coldness);
    std::vector<grid::BoxField> counts, sums;
    for (const int threads : {1, 2, 3}) {
        core::ThreadPool pool(threads);
        compute_shares(parcels, open, pool, shares);
        grid::BoxField count(kShape), sum(kShape, 0.5F);
        scatter(shares, {ones, amounts}, {&count, &sum}, pool);
        counts.push_back(count), sums.push_back(sum);
    }
    EXPECT_EQ(counts[0], counts[1]);
    EXPECT_EQ(sums[0], sums[1]);
    EXPECT_EQ(sums[0], sums[2]);
    EXPECT_NEAR(sum_of(counts[0]), 3000.0, 3e-3);
    const double amount = std::accumulate(amounts.begin(), amounts.end(), 0.0);
    const double before = 0.5 * static_cast<double>(kShape.sample_count());
    EXPECT_NEAR(sum_of(sums[0]), before + amount, 3e-3);
}

TEST(ParcelCells, SortedParcelsAreThoseThereWereCellByCell) {
    std::vector<Parcel> parcels = scattered(500);
    for (std::size_t i = 0; i < parcels.size(); ++i)
        parcels[i].ball = static_cast<int>(i);
    const std::vector<Parcel> before = parcels;
    sort_by_cells(kShape, parcels);
    const auto cell_of = [](const Parcel& parcel) {
        const glm::ivec3 cell(parcel.position_m / kShape.cell_m);
        return kShape.index(cell.x, cell.y, cell.z);
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

TEST(ParcelCellsDeathTest, APositionThatIsNoNumberIsFoundAtOnce) {
    const Parcel parcel{{0.0F / 0.0F, 0.015F, 0.025F}, 1.0F};
    EXPECT_DEATH(shares_of(parcel, grid::BoxField(kShape, 1.0F)), "broken invariant");
}

}  // namespace
}  // namespace pastoso::liquid
