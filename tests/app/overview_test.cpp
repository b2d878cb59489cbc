// The small picture of the whole canvas: what it shows, and that it follows changed tiles alone.
#include "session/overview.hpp"

#include "document/painting.hpp"
#include "pigment/hex_colour.hpp"

#include <algorithm>
#include <future>
#include <utility>

#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

/// 256 x 128 cells: 4 x 2 tiles.
film::FilmState bare() {
    return film::FilmState({256, 128}, 0.25);
}

void cover(film::FilmState& film, const grid::Rect& cells) {
    film::PaintCell paint{};
    std::fill_n(paint.begin(), film::kPigmentChannels / 2, 1 << 18);
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            film.thickness.set(x, y, film::kMaxThickness_quanta / 50);
            film.paint.set(x, y, paint);
        }
    }
}

OverviewSubject subject(film::FilmState film, std::vector<int> tiles) {
    return {std::make_shared<const film::FilmState>(std::move(film)),
            document::kPrimedGround,
            {},
            std::move(tiles)};
}

int red_at(const pigment::Image8& picture, int x, int y) {
    return picture.rgb[static_cast<std::size_t>(3 * (y * picture.width + x))];
}

TEST(Overview, IsTheWholeCanvasInItsProportions) {
    Overview overview(100, 100);
    film::FilmState film = bare();
    cover(film, {128, 0, 256, 128});
    const pigment::Image8& picture = overview.update(subject(film, {}));
    EXPECT_EQ(picture.width, 100);
    EXPECT_EQ(picture.height, 50);
    ASSERT_EQ(picture.rgb.size(), 3U * 100U * 50U);
    for (const int y : {0, 25, 49}) {
        EXPECT_GT(red_at(picture, 0, y), 200);
        EXPECT_GT(red_at(picture, 49, y), 200);
        EXPECT_LT(red_at(picture, 50, y), 100);
        EXPECT_LT(red_at(picture, 99, y), 100);
    }
}

TEST(Overview, PaintsTheChangedTilesAlone) {
    Overview overview(64, 64);
    overview.update(subject(bare(), {}));
    film::FilmState film = bare();
    cover(film, film.shape.cells());
    const pigment::Image8& picture = overview.update(subject(film, {2}));  // the third of the upper row
    EXPECT_LT(red_at(picture, 40, 8), 100);
    EXPECT_GT(red_at(picture, 8, 8), 200);
    EXPECT_GT(red_at(picture, 40, 24), 200);
    EXPECT_GT(red_at(picture, 60, 8), 200);
}

TEST(Overview, TileByTileItBecomesWhatItIsAtOnce) {
    film::FilmState film = bare();
    cover(film, {30, 20, 150, 100});
    Overview at_once(57, 57), by_tiles(57, 57);
    by_tiles.update(subject(bare(), {}));
    const auto whole = at_once.update(subject(film, {})).rgb;
    for (int tile = 0; tile < film.shape.tile_count(); ++tile)
        by_tiles.update(subject(film, {tile}));
    EXPECT_EQ(by_tiles.update(subject(film, {})).rgb, whole);
}

TEST(Overview, AnotherLightPaintsAllOfItAnew) {
    Overview overview(64, 64);
    const auto daylight = overview.update(subject(bare(), {})).rgb;
    OverviewSubject lamp = subject(bare(), {});
    for (float& weight : lamp.viewing.to_rgb[0])
        weight *= 0.5F;
    EXPECT_NE(overview.update(lamp).rgb, daylight);
}

TEST(OverviewPainter, DeliversWhatWasAskedForLast) {
    std::promise<void> dark;
    bool done = false;
    OverviewPainter painter(
        64, 64,
        [&](const pigment::Image8& picture) {
            if (done || red_at(picture, 8, 8) > 100 || red_at(picture, 60, 24) > 100) return;
            done = true;
            dark.set_value();
        },
        [](const core::Message& fault) { ADD_FAILURE() << fault.text(); });
    film::FilmState film = bare();
    painter.want(subject(film, {}));
    cover(film, {0, 0, 64, 64});
    painter.want(subject(film, {0}));
    cover(film, {192, 64, 256, 128});
    painter.want(subject(film, {7}));
    dark.get_future().wait();
}

}  // namespace
}  // namespace pastoso::session
