#include "layers/extent.hpp"

#include "layers/cutting.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using test::sums_of;

film::MediaCell media_at(const FilmState& film, int x, int y) {
    return film::media_in(film, film.shape.tile_at(x, y), grid::Shape::cell_in_tile(x, y));
}

TEST(LayerExtent, MakingRoomLosesNothingAndIsTakenBack) {
    FilmState layer = test::random_layer(3);
    const FilmState wide = on_extent(layer, {{220, 190}, -33, -60});
    EXPECT_EQ(sums_of(wide), sums_of(layer));
    EXPECT_EQ(wide.thickness.at(33 + 20, 60 + 10), layer.thickness.at(20, 10));
    EXPECT_EQ(wide.worked.thickness.at(33 + 20, 60 + 10), layer.worked.thickness.at(20, 10));
    for (int y = 0; y < layer.shape.height; ++y)
        for (int x = 0; x < layer.shape.width; ++x)
            ASSERT_EQ(media_at(wide, 33 + x, 60 + y), media_at(layer, x, y));
    const FilmState back = on_extent(wide, {test::kShape, 33, 60});
    EXPECT_EQ(film::state_hash(back), film::state_hash(layer));
}

TEST(LayerExtent, TwoHalvesHoldWhatTheWholeHeld) {
    const FilmState layer = test::random_layer(4);
    FilmState left = on_extent(layer, {{71, 70}});
    const FilmState right = on_extent(layer, {{79, 70}, 71, 0});
    const auto a = sums_of(left), b = sums_of(right), whole = sums_of(layer);
    left.strata.evaporated = 0;  // is counted in both
    EXPECT_EQ(sums_of(left).thickness + b.thickness, whole.thickness);
    EXPECT_EQ(a.relief + b.relief, whole.relief);
    for (std::size_t k = 0; k < whole.pigment.size(); ++k)
        EXPECT_NEAR(static_cast<double>(a.pigment[k] + b.pigment[k]),
                    static_cast<double>(whole.pigment[k]), 1.0);  // fixed pigment is shared and rounded
}

TEST(LayerExtent, HeightsGoOnBeyondTheEdges) {
    Heights heights({4, 3});
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x)
            heights.set(x, y, static_cast<float>(10 * y + x));
    const Heights wide = widened(heights, {{7, 6}, -2, -1});
    EXPECT_EQ(wide.at(2, 1), 0.0F);
    EXPECT_EQ(wide.at(0, 0), 0.0F);
    EXPECT_EQ(wide.at(4, 3), 22.0F);
    EXPECT_EQ(wide.at(6, 2), 13.0F);
    EXPECT_EQ(wide.at(3, 5), 21.0F);
    EXPECT_EQ(wide.at(6, 5), 23.0F);
}

}  // namespace
}  // namespace pastoso::layers
