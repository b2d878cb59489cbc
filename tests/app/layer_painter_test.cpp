// Pictures of layers: what paint covers, its colour, and only the latest film of each layer.
#include "session/layer_painter.hpp"

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "film/cell/drying.hpp"

#include <algorithm>
#include <future>
#include <new>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::session {
namespace {

/// 128 x 64 cells with wet paint over all of their left half, as dense as it is thick.
film::FilmState half_covered() {
    film::FilmState film({128, 64}, 0.5);
    film::PaintCell paint{};
    std::fill_n(paint.begin(), film::kPigmentChannels, 1 << 16);
    paint[film::kSolidsChannel] = 1 << 15;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            film.thickness.set(x, y, film::kMaxThickness_quanta / 50);
            film.paint.set(x, y, paint);
        }
    }
    return film;
}

std::uint8_t cover_at(const LayerPicture& picture, int x, int y) {
    return picture.rgba[static_cast<std::size_t>(4 * (y * picture.width + x) + 3)];
}

TEST(LayerPicture, CoversWhatThePaintCovers) {
    const LayerPicture picture = layer_picture(half_covered(), document::kPrimedGround, 50, 50);
    EXPECT_EQ(picture.width, 50);
    EXPECT_EQ(picture.height, 25);
    ASSERT_EQ(picture.rgba.size(), 4U * 50U * 25U);
    EXPECT_TRUE(picture.wet);
    for (int y = 0; y < picture.height; ++y) {
        EXPECT_EQ(cover_at(picture, 0, y), 255);
        EXPECT_EQ(cover_at(picture, 24, y), 255);
        EXPECT_EQ(cover_at(picture, 25, y), 0);
        EXPECT_EQ(cover_at(picture, 49, y), 0);
    }
}

TEST(LayerPicture, SmallCanvasesAndBareLayersHaveOneToo) {
    const LayerPicture picture =
        layer_picture(film::FilmState({3, 200}, 0.5), document::kPrimedGround, 52, 36);
    EXPECT_EQ(picture.width, 1);
    EXPECT_EQ(picture.height, 36);
    EXPECT_FALSE(picture.wet);
    EXPECT_EQ(cover_at(picture, 0, 20), 0);
}

TEST(LayerPicture, DryPaintIsSeenAndNotWet) {
    film::FilmState film = half_covered();
    core::ThreadPool pool(1);
    film::dry_now(film, pool);
    const LayerPicture picture = layer_picture(film, document::kPrimedGround, 50, 50);
    EXPECT_FALSE(picture.wet);
    EXPECT_EQ(cover_at(picture, 10, 10), 255);
    EXPECT_EQ(cover_at(picture, 40, 10), 0);
}

TEST(LayerPainter, DeliversEveryLayerThatIsAskedFor) {
    std::promise<void> first, second;
    LayerPainter painter(
        20, 20,
        [&](document::LayerId layer, const LayerPicture& picture) {
            EXPECT_EQ(picture.width, 20);
            (layer == 7 ? first : second).set_value();
        },
        [](const core::Message& fault) { ADD_FAILURE() << fault.text(); });
    const auto film = std::make_shared<const film::FilmState>(half_covered());
    painter.want(7, film, document::kPrimedGround);
    painter.want(8, film, document::kPrimedGround);
    first.get_future().wait();
    second.get_future().wait();
}

TEST(LayerPainter, TellsWhyAPictureIsMissingAndPaintsTheNext) {
    std::promise<std::string> told;
    std::promise<void> delivered;
    LayerPainter painter(
        20, 20,
        [&](document::LayerId layer, const LayerPicture&) {
            if (layer == 7) throw std::bad_alloc();
            delivered.set_value();
        },
        [&](const core::Message& fault) { told.set_value(fault.text()); });
    const auto film = std::make_shared<const film::FilmState>(half_covered());
    painter.want(7, film, document::kPrimedGround);
    painter.want(8, film, document::kPrimedGround);
    EXPECT_EQ(told.get_future().get().substr(0, 15), "memory ran out:");
    delivered.get_future().wait();
}

}  // namespace
}  // namespace pastoso::session
