#include "liquid/tea/parcel_cells.hpp"

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

double sum_of(const grid::BoxField& field) {
    return std::accumulate(field.values().begin(), field.values().end(), 0.0);
}

TEST(ParcelCells, InTheMiddleOfACellItGetsAll) {
    const Parcel parcel{{0.025F, 0.015F, 0.025F}, 1.0F};
    grid::BoxField field(kShape);
    const std::vector<float> amounts = {2.0F};
    scatter(shares_of(parcel, grid::BoxField(kShape, 1.0F)), amounts, field);
    // Positions are floats.
    EXPECT_NEAR(field.at(2, 1, 2), 2.0F, 1e-5F);
    EXPECT_NEAR(sum_of(field), 2.0, 1e-6);
}

TEST(ParcelCells, BetweenMiddlesSharesAreTrilinear) {
    const Parcel parcel{{0.03F, 0.015F, 0.0275F}, 1.0F};
    grid::BoxField field(kShape);
    const std::vector<float> amounts = {1.0F};
    scatter(shares_of(parcel, grid::BoxField(kShape, 1.0F)), amounts, field);
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
    const std::vector<float> amounts = {1.0F};
    scatter(shares_of(parcel, open), amounts, field);
    EXPECT_NEAR(field.at(2, 1, 2), 1.0F, 1e-5F);
    EXPECT_EQ(field.at(3, 1, 2), 0.0F);
}

TEST(ParcelCells, WhereNoCellIsOpenThereAreNoShares) {
    const Parcel parcel{{0.03F, 0.015F, 0.025F}, 1.0F};
    EXPECT_FALSE(shares_of(parcel, grid::BoxField(kShape)).front().any());
}

TEST(ParcelCellsDeathTest, APositionThatIsNoNumberIsFoundAtOnce) {
    const Parcel parcel{{0.0F / 0.0F, 0.015F, 0.025F}, 1.0F};
    EXPECT_DEATH(shares_of(parcel, grid::BoxField(kShape, 1.0F)), "broken invariant");
}

}  // namespace
}  // namespace pastoso::liquid
