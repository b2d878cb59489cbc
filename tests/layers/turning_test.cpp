#include "layers/turning.hpp"

#include "film/support/support.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"
#include "layers/transform.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using core::Orientation;
using film::FilmState;
using test::sums_of;

constexpr Orientation kMirror{true, 0}, kUpsideDown{true, 2}, kRight{false, 1}, kLeft{false, 3},
    kAround{false, 2};

class Turning : public testing::Test {
  protected:
    /// Paint of every kind that flows, at the canvas's edges too.
    static FilmState moving_layer(std::uint32_t seed) {
        FilmState layer = test::random_layer(seed);
        for (int y = 0; y < test::kShape.height; ++y)
            for (int x = 0; x < test::kShape.width; ++x) {
                if (!test::chance(x, y, seed + 40, 0.3F)) continue;
                layer.velocity_x.set(x, y, static_cast<float>(x - 60) / 8.0F);
                layer.velocity_y.set(x, y, static_cast<float>(y - 20) / 4.0F);
            }
        return layer;
    }
    FilmState turn(const FilmState& layer, const Orientation& how) { return turned(layer, how, pool); }
    std::uint64_t hash(const FilmState& layer, std::initializer_list<Orientation> turns) {
        FilmState result = layer;
        for (const Orientation& how : turns)
            result = turn(result, how);
        return film::state_hash(result);
    }

    core::ThreadPool pool{2};
};

film::MediaCell media_at(const FilmState& film, int x, int y) {
    return film::media_in(film, film.shape.tile_at(x, y), grid::Shape::cell_in_tile(x, y));
}

TEST_F(Turning, BackAgainItIsTheSameToTheBit) {
    const FilmState layer = moving_layer(5);
    const std::uint64_t before = film::state_hash(layer);
    EXPECT_EQ(hash(layer, {kMirror, kMirror}), before);
    EXPECT_EQ(hash(layer, {kUpsideDown, kUpsideDown}), before);
    EXPECT_EQ(hash(layer, {kRight, kRight, kRight, kRight}), before);
    EXPECT_EQ(hash(layer, {kRight, kLeft}), before);
    EXPECT_EQ(hash(layer, {kAround, kAround}), before);
    EXPECT_NE(hash(layer, {kMirror}), before);
}

TEST_F(Turning, OneAfterTheOtherIsBothAtOnce) {
    const FilmState layer = moving_layer(6);
    EXPECT_EQ(hash(layer, {kMirror, kUpsideDown}), hash(layer, {kAround}));
    EXPECT_EQ(hash(layer, {kRight, kRight, kRight}), hash(layer, {kLeft}));
    EXPECT_EQ(hash(layer, {kMirror, kRight}), hash(layer, {Orientation{true, 1}}));
    EXPECT_NE(hash(layer, {kMirror, kRight}), hash(layer, {kRight, kMirror}));
}

TEST_F(Turning, EveryCellKeepsAllThatItHolds) {
    const FilmState layer = moving_layer(7), right = turn(layer, kRight);
    const int bottom = layer.shape.height - 1;
    ASSERT_EQ(right.shape, (grid::Shape{70, 150}));
    for (int y = 0; y <= bottom; ++y)
        for (int x = 0; x < layer.shape.width; ++x) {
            const int to_x = bottom - y, to_y = x;
            ASSERT_EQ(right.thickness.at(to_x, to_y), layer.thickness.at(x, y)) << x << ", " << y;
            ASSERT_EQ(right.paint.at(to_x, to_y), layer.paint.at(x, y));
            ASSERT_EQ(right.worked.thickness.at(to_x, to_y), layer.worked.thickness.at(x, y));
            ASSERT_EQ(right.lower.thickness.at(to_x, to_y), layer.lower.thickness.at(x, y));
            ASSERT_EQ(right.lower.paint.at(to_x, to_y), layer.lower.paint.at(x, y));
            ASSERT_EQ(right.support_mm.at(to_x, to_y), layer.support_mm.at(x, y));
            ASSERT_EQ(right.strata.optics.at(to_x, to_y), layer.strata.optics.at(x, y));
            ASSERT_EQ(right.strata.uppermost.at(to_x, to_y), layer.strata.uppermost.at(x, y));
            ASSERT_EQ(media_at(right, to_x, to_y), media_at(layer, x, y));
        }
    EXPECT_EQ(sums_of(right), sums_of(layer));
}

TEST_F(Turning, AMirroredLayerIsTheOneThatATransformMirrors) {
    const FilmState layer = test::random_layer(8);
    const Transform mirror{.centre_x_mm = 0.5 * test::kShape.width * test::kCell_mm,
                           .centre_y_mm = 0.5 * test::kShape.height * test::kCell_mm,
                           .scale_x = -1.0};
    EXPECT_EQ(hash(layer, {kMirror}),
              film::state_hash(transformed(layer, in_cells(mirror, test::kCell_mm), pool)));
}

TEST_F(Turning, PaintFlowsTheWayThatHasTurnedWithIt) {
    FilmState layer = test::bare_layer();
    layer.velocity_x.set(10, 20, 3.0F);  // from (10, 20) to (11, 20)
    layer.velocity_y.set(40, 5, -2.0F);  // from (40, 6) to (40, 5)
    const FilmState mirrored = turn(layer, kMirror);
    EXPECT_EQ(mirrored.velocity_x.at(138, 20), -3.0F) << "from (139, 20) to (138, 20)";
    EXPECT_EQ(mirrored.velocity_y.at(109, 5), -2.0F);
    const FilmState right = turn(layer, kRight);
    EXPECT_EQ(right.velocity_y.at(49, 10), 3.0F) << "downwards";
    EXPECT_EQ(right.velocity_x.at(63, 40), 2.0F) << "to the right, from (63, 40) to (64, 40)";
}

TEST_F(Turning, HeightsStayInTheirForm) {
    constexpr grid::Shape kSize{150, 70};
    for (const film::SupportForm form : {film::SupportForm::Levels, film::SupportForm::Fine}) {
        const Heights linen = film::named_support("linen", kSize, 0.25, 0.0, pool, form);
        const Heights right = turned(linen, kRight, pool);
        for (int tile = 0; tile < right.tile_count(); ++tile)
            EXPECT_EQ(right.block(tile).in_levels(), form == film::SupportForm::Levels);
        EXPECT_EQ(right.at(69 - 12, 140), linen.at(140, 12));
    }
    Heights mixed = film::named_support("linen", kSize, 0.25, 0.0, pool);
    mixed.set(3, 3, 0.5F);
    EXPECT_EQ(turned(mixed, kMirror, pool).at(146, 3), 0.5F);
}

TEST_F(Turning, ATracingTurnsWithItsPlace) {
    const auto picture =
        std::make_shared<const pigment::Picture>(pigment::Picture{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}});
    const Tracing tracing{picture, {10.0, 4.0, 20.0, 6.0}, 0.25};
    const Tracing right = turned(tracing, kRight, 100.0, 50.0);
    EXPECT_EQ(right.place, (PicturePlace{40.0, 10.0, 6.0, 20.0}));
    EXPECT_EQ(*right.picture, (pigment::Picture{1, 2, {1, 2, 3, 4, 5, 6, 7, 8}}));
    EXPECT_EQ(right.opacity, 0.25);
    const Tracing mirrored = turned(tracing, kMirror, 100.0, 50.0);
    EXPECT_EQ(mirrored.place, (PicturePlace{70.0, 4.0, 20.0, 6.0}));
    EXPECT_EQ(*mirrored.picture, (pigment::Picture{2, 1, {5, 6, 7, 8, 1, 2, 3, 4}}));
}

}  // namespace
}  // namespace pastoso::layers
