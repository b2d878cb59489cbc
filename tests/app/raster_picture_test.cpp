#include "screen/raster_picture.hpp"

#include "appearance/dither.hpp"
#include "files/made_profiles.hpp"
#include "files/screen_colours.hpp"
#include "pigment/colour.hpp"

#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace pastoso::screen {
namespace {

using appearance::dither_threshold;
using appearance::dithered;

constexpr QSize kWindow_px(64, 48);

/// A flat canvas, warm grey and bare.
std::shared_ptr<document::Snapshot> bare_canvas(int width, int height) {
    auto snapshot = std::make_shared<document::Snapshot>();
    snapshot->film = film::FilmState({width, height}, 0.125);
    snapshot->ground = {0.30F, 0.33F, 0.36F, 0.41F, 0.47F, 0.50F};
    return snapshot;
}

/// All of the window shows canvas, a pixel a cell.
RasterScene scene_of(std::shared_ptr<const document::Snapshot> painting, float direct) {
    RasterScene scene{{std::move(painting), {}, {}, {}, Look::Lit}, {}, kWindow_px, {}, {}};
    scene.view.zoom = 1.0;
    scene.view.origin_px = {-40.0, -30.0};
    scene.sight.lighting.elevation_deg = 30.0 + 40.0 * direct;
    return scene;
}

/// As it is to be, however slow the machine is.
void show(RasterPicture& picture, const RasterScene& scene) {
    core::ThreadPool pool(2);
    picture.show(scene, pool);
    while (picture.is_draft())
        picture.refine(pool);
}

QImage shown(const RasterScene& scene) {
    RasterPicture picture;
    show(picture, scene);
    return picture.image();
}

/// What no level has taken anything from, 0 to 1: in the middle of the canvas all pixels are alike.
pigment::EncodedRgb exact_colour(const RasterScene& scene) {
    core::ThreadPool pool(2);
    const document::Snapshot& painting = *scene.sight.painting;
    shade::RenderSettings settings;
    settings.lighting = scene.sight.lighting;
    const pigment::LinearImage lit =
        shade::render(painting.film, painting.ground, {60, 50, 61, 51}, settings, pool);
    pigment::EncodedRgb colour{};
    for (int i = 0; i < 3; ++i)
        colour[i] = static_cast<float>(pigment::encode_srgb(lit.rgb[i]));
    return colour;
}

/// Of 255 levels, over 8 x 8 pixels of the middle.
std::array<double, 3> mean_levels(const QImage& image, int left, int top) {
    std::array<double, 3> mean{};
    for (int y = top; y < top + 8; ++y)
        for (int x = left; x < left + 8; ++x) {
            const QRgb pixel = image.pixel(x, y);
            mean[0] += qRed(pixel) / 64.0;
            mean[1] += qGreen(pixel) / 64.0;
            mean[2] += qBlue(pixel) / 64.0;
        }
    return mean;
}

TEST(Dither, HoldsEveryThresholdOnceInAnyEightByEight) {
    for (const int corner : {0, 3, 8, 21}) {
        std::set<float> thresholds;
        for (int y = corner; y < corner + 8; ++y)
            for (int x = 2 * corner; x < 2 * corner + 8; ++x)
                thresholds.insert(dither_threshold(x, y));
        EXPECT_EQ(thresholds.size(), 64U);
        EXPECT_GT(*thresholds.begin(), 0.0F);
        EXPECT_LT(*thresholds.rbegin(), 1.0F);
    }
}

TEST(Dither, LeavesLevelsAsTheyAre) {
    for (int level = 0; level < 256; ++level)
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                EXPECT_EQ(dithered(static_cast<float>(level) / 255.0F, dither_threshold(x, y)), level);
}

// Half a step of 64, and a level of the 16 bits before.
TEST(RasterPicture, HasTheMeanOfWhatItShows) {
    constexpr double kRoom = 0.5 / 64.0 + 0.01;
    const auto painting = bare_canvas(160, 120);
    for (const float direct : {0.0F, 0.1F, 0.35F, 0.6F, 1.0F}) {
        const RasterScene scene = scene_of(painting, direct);
        const QImage image = shown(scene);
        const pigment::EncodedRgb wanted = exact_colour(scene);
        for (const int corner : {8, 13, 24}) {
            const auto mean = mean_levels(image, corner, corner);
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(mean[i], 255.0 * wanted[i], kRoom) << direct;
        }
    }
}

TEST(RasterPicture, WhatIsDrawnInPartsIsWhatIsDrawnAtOnce) {
    const auto painting = bare_canvas(160, 120);
    RasterPicture picture;
    RasterScene scene = scene_of(painting, 0.4F);
    scene.ground = {0.21F, 0.21F, 0.21F};
    scene.view.origin_px = {10.0, -30.0};
    show(picture, scene);
    for (int step = 0; step < 3; ++step) {
        auto next = std::make_shared<document::Snapshot>(*scene.sight.painting);
        for (int y = 30; y < 40; ++y)
            for (int x = 20 + 7 * step; x < 28 + 7 * step; ++x)
                next->film.thickness.set(x, y, 1000 * (x % 4));
        scene.sight.painting = next;
        show(picture, scene);
        EXPECT_EQ(picture.image(), shown(scene));
    }
}

TEST(RasterPicture, ShowsTheCanvasThroughTheScreensColours) {
    constexpr double kGamma = 1.8;
    const auto painting = bare_canvas(160, 120);
    RasterScene scene = scene_of(painting, 0.4F);
    scene.ground = {60.0F / 255.0F, 70.0F / 255.0F, 80.0F / 255.0F};
    scene.view.origin_px = {30.0, -30.0};  // of ground 30 columns
    const pigment::EncodedRgb plain = exact_colour(scene);
    RasterPicture picture;
    show(picture, scene);
    const QImage before = picture.image();
    scene.colours =
        files::screen_cube({.monitor = tests::made_monitor(tests::swapped_primaries(), kGamma)});
    show(picture, scene);
    EXPECT_EQ(picture.image(), shown(scene)) << "coloured anew is drawn anew";
    const auto mean = mean_levels(picture.image(), 40, 20);
    const double wanted[] = {plain[1], plain[0], plain[2]};
    // A fifth of a level between the nodes of the table.
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(mean[i], 255.0 * std::pow(pigment::decode_srgb(wanted[i]), 1.0 / kGamma), 0.25);
    EXPECT_EQ(picture.image().copy(0, 0, 30, 48), before.copy(0, 0, 30, 48)) << "the ground";
}

/// Its pixels at the edges reach over the canvas by many cells.
TEST(RasterPicture, IsADraftFromAfarToo) {
    core::ThreadPool pool(2);
    for (const Look look : {Look::Lit, Look::Flat, Look::Wet, Look::Normals})
        for (const double zoom : {0.21, 0.17, 0.09, 0.04}) {
            RasterScene scene = scene_of(bare_canvas(1050, 750), 0.4F);
            scene.sight.look = look;
            scene.window_px = {500, 400};
            scene.view = {{3.3, 2.7}, zoom};
            RasterPicture picture;
            EXPECT_TRUE(picture.show(scene, pool)) << zoom;
            show(picture, scene);
            EXPECT_EQ(picture.image(), shown(scene)) << zoom;
        }
}

TEST(RasterPicture, MarksWhatAPrinterHasNot) {
    const auto painting = bare_canvas(160, 120);
    RasterScene scene = scene_of(painting, 0.4F);
    const files::IccProfile printer = tests::made_printer();
    scene.colours = files::screen_cube({.printer = printer, .gamut_warning = true});
    EXPECT_EQ(shown(scene).pixel(20, 20), shown(scene_of(painting, 0.4F)).pixel(20, 20))
        << "a warm grey";
    const auto green = bare_canvas(160, 120);
    green->ground = {0.0F, 0.05F, 1.0F, 0.9F, 0.0F, 0.0F};
    scene.sight.painting = green;
    const QRgb mark = shown(scene).pixel(20, 20);
    EXPECT_NEAR(qRed(mark), 127.5, 0.51);
    EXPECT_EQ(qRed(mark), qGreen(mark));
    EXPECT_EQ(qRed(mark), qBlue(mark));
}

}  // namespace
}  // namespace pastoso::screen
