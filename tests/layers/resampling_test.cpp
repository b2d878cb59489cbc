// Layers on canvases of other cells.
#include "layers/resampling.hpp"

#include "layers/random_layer.hpp"
#include "layers/sums.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using test::kCell_mm;
using test::kShape;
using test::Sums;
using test::sums_of;

/// So many cells for each.
Resampling finer(double times) {
    const auto cells = [times](int count) { return static_cast<int>(std::lround(times * count)); };
    return {.map = {times, 0.0, 0.0, 0.0, times, 0.0},
            .shape = {cells(kShape.width), cells(kShape.height)},
            .cell_mm = kCell_mm / times,
            .beyond = Beyond::GoesOn};
}

/// Half a step of the support, 2^-20 mm, in reliefs of some 0.1 mm.
constexpr double kRounding = 5e-6;

void expect_times(const Sums& after, const Sums& before, double area) {
    const auto near = [area](std::int64_t now, std::int64_t then) {
        const double wanted = area * static_cast<double>(then);
        EXPECT_NEAR(static_cast<double>(now), wanted, kRounding * std::abs(wanted) + 20000.0);
    };
    near(after.thickness, before.thickness);
    near(after.relief, before.relief);
    for (int k = 0; k < film::kPigmentChannels; ++k)
        near(after.pigment[k], before.pigment[k]);
}

class Resampled : public testing::Test {
  protected:
    core::ThreadPool pool{2};
};

TEST_F(Resampled, CellsThatFitKeepWhatLies) {
    const FilmState layer = test::random_layer(3);
    const Sums before = sums_of(layer);
    expect_times(sums_of(resampled(layer, finer(2.0), pool)), before, 4.0);
    expect_times(sums_of(resampled(layer, finer(3.0), pool)), before, 9.0);
    expect_times(sums_of(resampled(layer, finer(0.5), pool)), before, 0.25);
    expect_times(sums_of(resampled(layer, finer(0.1), pool)), before, 0.01);
}

TEST_F(Resampled, OfAnEvenFilmEveryCellIsTheSameUpToTheEdges) {
    FilmState layer = test::bare_layer();
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            film::test::lay(layer, x, y, 0.4, film::test::kBlue, film::find_medium("heavy-body oil"));
    for (const double times : {0.37, 1.7, 2.6}) {
        const FilmState other = resampled(layer, finer(times), pool);
        for (int y = 0; y < other.shape.height; ++y)
            for (int x = 0; x < other.shape.width; ++x) {
                ASSERT_EQ(other.thickness.at(x, y), layer.thickness.at(0, 0)) << x << ", " << y;
                ASSERT_EQ(other.paint.at(x, y), layer.paint.at(0, 0));
            }
    }
}

TEST_F(Resampled, BareBeyondTheEdgesNothingComesFromThere) {
    FilmState layer = test::bare_layer();
    film::test::lay(layer, 0, 0, 0.4, film::test::kBlue, film::find_medium("heavy-body oil"));
    Resampling doubled = finer(2.0);
    doubled.beyond = Beyond::Bare;
    const FilmState other = resampled(layer, doubled, pool);
    EXPECT_LT(other.thickness.at(0, 0), layer.thickness.at(0, 0));
    EXPECT_EQ(resampled(layer, finer(2.0), pool).thickness.at(0, 0), layer.thickness.at(0, 0));
}

TEST_F(Resampled, WhatHasEvaporatedKeepsItsVolume) {
    FilmState layer = test::bare_layer();
    layer.strata.evaporated = 8000;
    EXPECT_EQ(resampled(layer, finer(2.0), pool).strata.evaporated, 32000);
    EXPECT_EQ(resampled(layer, finer(0.5), pool).strata.evaporated, 2000);
}

TEST_F(Resampled, TheSameCellsAreTheSameBits) {
    const FilmState layer = test::random_layer(4);
    EXPECT_EQ(film::state_hash(resampled(layer, finer(1.0), pool)), film::state_hash(layer));
}

TEST_F(Resampled, AnyNumberOfThreadsGivesTheSame) {
    const FilmState layer = test::random_layer(5);
    core::ThreadPool one(1);
    EXPECT_EQ(film::state_hash(resampled(layer, finer(1.3), one)),
              film::state_hash(resampled(layer, finer(1.3), pool)));
}

TEST_F(Resampled, MirroredIsMirrored) {
    const FilmState layer = test::random_layer(6);
    const double width = kShape.width;
    const FilmState mirrored = resampled(
        layer, {.map = {-1.0, 0.0, width, 0.0, 1.0, 0.0}, .shape = kShape, .cell_mm = kCell_mm}, pool);
    const Resampling scaling = finer(1.6);
    const FilmState a = resampled(layer, scaling, pool), b = resampled(mirrored, scaling, pool);
    for (int y = 0; y < a.shape.height; ++y)
        for (int x = 0; x < a.shape.width; ++x)
            ASSERT_NEAR(a.thickness.at(x, y), b.thickness.at(a.shape.width - 1 - x, y), 1)
                << x << ", " << y;
}

TEST_F(Resampled, ASlopeOfTheSupportGoesOn) {
    Heights slope(kShape);
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            slope.set(x, y, 0.125F * static_cast<float>(x));
    const Heights doubled = resampled(slope, finer(2.0), pool);
    EXPECT_EQ(doubled.shape(), (grid::Shape{300, 140}));
    EXPECT_EQ(doubled.at(0, 7), 0.0F);
    EXPECT_EQ(doubled.at(299, 7), slope.at(149, 0));
    for (int x = 1; x < 299; ++x)
        ASSERT_NEAR(doubled.at(x, 7), 0.0625 * x - 0.03125, film::kSupportQuantum_mm) << x;
}

TEST_F(Resampled, AMaskIsOfTheCellsThatItsMiddlesComeFrom) {
    grid::Mask mask(kShape);
    for (int y = 10; y < 20; ++y)
        for (int x = 30; x < 150; ++x)
            mask.set(x, y, grid::kWhole);
    EXPECT_EQ(grid::chosen_area(resampled(mask, finer(2.0))), (grid::Rect{60, 20, 300, 40}));
    EXPECT_EQ(grid::chosen_area(resampled(mask, finer(0.5))), (grid::Rect{15, 5, 75, 10}));
}

}  // namespace
}  // namespace pastoso::layers
