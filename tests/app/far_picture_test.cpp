#include "screen/far_picture.hpp"

#include "pigment/colour.hpp"
#include "screen/raster_picture.hpp"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace pastoso::screen {
namespace {

constexpr QSize kWindow_px(90, 70);

core::ThreadPool& pool() {
    static core::ThreadPool threads(2);
    return threads;
}

QImage empty_window() {
    QImage window(kWindow_px, QImage::Format_RGBX64);
    window.fill(Qt::black);
    return window;
}

/// Of these far pixels, whose grey runs to the right and whose blue runs down.
pigment::LinearImage slopes(const grid::Rect& pixels) {
    pigment::LinearImage picture{pixels.width(), pixels.height(), {}};
    for (int y = pixels.y0; y < pixels.y1; ++y)
        for (int x = pixels.x0; x < pixels.x1; ++x) {
            const float grey = 0.002F * (static_cast<float>(x) + 0.5F);
            picture.rgb.insert(picture.rgb.end(), {grey, grey, 0.002F * (static_cast<float>(y) + 0.5F)});
        }
    return picture;
}

class Far : public testing::Test {
  protected:
    /// 321 x 203 far pixels of slopes.
    Far() {
        far_.begin({1281, 810});
        const grid::Rect all{0, 0, 321, 203};
        far_.put(all, slopes(all), pool());
    }

    FarPicture far_;
};

double linear(quint16 encoded) {
    return pigment::decode_srgb(encoded / 65535.0);
}

/// How far the mean of a stretch of steps may be from the slope they stand for: what is left of the last
/// step beside whole ones, at its worst place.
double stretch_error(double zoom) {
    const double number = std::floor(std::log2(kFarZoom / zoom));
    const double step = 0.002 * std::exp2(number);
    const double length = kFarZoom / (zoom * std::exp2(number)), rest = length - std::floor(length);
    return step * rest * (1.0 - rest) / (2.0 * length);
}

// A mean of a slope is the slope in the middle, at any zoom and angle, but for the steps of pixels; two
// roundings to 16 bits are allowed, a rounding on each picture in between, and the encoding's.
TEST_F(Far, ShowsASlopeAsItIsFromAnywhere) {
    for (const double zoom : {0.25, 0.2, 0.1251, 0.125, 0.07, 1.0 / 32.0})
        for (const double angle_deg : {0.0, 90.0, 33.0, -121.0}) {
            ViewTransform view{{45.0, 35.0}, zoom, angle_deg, angle_deg > 50.0};
            view.origin_px -= zoom * (view.axes() * glm::dvec2{640.0, 400.0});
            QImage window = empty_window();
            far_.draw(view, window.rect(), window, pool());
            const double near = 1.2e-4 + stretch_error(zoom);
            for (int y = 0; y < kWindow_px.height(); y += 3)
                for (int x = 0; x < kWindow_px.width(); x += 3) {
                    const glm::dvec2 cell = view.cell_from_device({x + 0.5, y + 0.5});
                    const glm::dvec2 inside{std::min(cell.x, 1280.0 - cell.x),
                                            std::min(cell.y, 808.0 - cell.y)};
                    if (std::min(inside.x, inside.y) < 2.0 / zoom) continue;
                    const QRgba64 pixel = window.pixelColor(x, y).rgba64();
                    EXPECT_NEAR(linear(pixel.red()), 0.0005 * cell.x, near) << zoom << ' ' << angle_deg;
                    EXPECT_NEAR(linear(pixel.blue()), 0.0005 * cell.y, near) << zoom << ' ' << angle_deg;
                }
        }
}

TEST_F(Far, ShowsItsOwnPixelsAsTheyAre) {
    QImage window = empty_window();
    far_.draw({{-20.0, -10.0}, kFarZoom}, window.rect(), window, pool());
    for (int x = 0; x < kWindow_px.width(); ++x)
        EXPECT_NEAR(linear(window.pixelColor(x, 4).rgba64().red()), 0.002 * (x + 20.5), 2e-5);
}

TEST_F(Far, KnowsWhatItWasGivenUntilItIsTold) {
    const QRect window(QPoint(0, 0), kWindow_px);
    for (const double zoom : {0.25, 0.06}) {
        const ViewTransform view{{3.0, 4.0}, zoom, 20.0};
        EXPECT_TRUE(far_.missing(view, window).isEmpty());
    }
    far_.forget(QRect(41, 82, 1, 5));
    const ViewTransform near{{0.0, 0.0}, kFarZoom};
    EXPECT_EQ(far_.missing(near, window), QRegion(10, 20, 1, 2));
    EXPECT_TRUE(far_.missing(near, QRect(14, 0, 20, 70)).isEmpty());
    EXPECT_FALSE(far_.missing({{0.0, 0.0}, 1.0 / 64.0}, QRect(0, 1, 1, 1)).isEmpty())
        << "it has a part in a pixel that is sixteen wide";
    far_.put({10, 20, 11, 22}, slopes({10, 20, 11, 22}), pool());
    EXPECT_TRUE(far_.missing(near, window).isEmpty());
}

TEST_F(Far, APartThatWasPutAgainIsInAllOfItsPictures) {
    pigment::LinearImage white{37, 41, std::vector<float>(3 * 37 * 41, 1.0F)};
    FarPicture whole, parts;
    whole.begin({1281, 810});
    parts.begin({1281, 810});
    pigment::LinearImage all = slopes({0, 0, 321, 203});
    parts.put({0, 0, 321, 203}, all, pool());
    parts.put({201, 77, 238, 118}, white, pool());
    for (int y = 77; y < 118; ++y)
        for (int x = 3 * 201; x < 3 * 238; ++x)
            all.rgb[static_cast<std::size_t>(3 * 321 * y + x)] = 1.0F;
    whole.put({0, 0, 321, 203}, all, pool());
    for (const double zoom : {0.25, 0.11, 1.0 / 40.0}) {
        QImage a = empty_window(), b = empty_window();
        const ViewTransform view{{-300.0 * zoom, -100.0 * zoom}, zoom, 7.0};
        whole.draw(view, a.rect(), a, pool());
        parts.draw(view, b.rect(), b, pool());
        EXPECT_EQ(a, b) << zoom;
    }
}

TEST_F(Far, AnotherCanvasBeginsWithNothing) {
    far_.begin({400, 300});
    EXPECT_EQ(far_.missing({{0.0, 0.0}, kFarZoom}, {0, 0, 90, 70}), QRegion(0, 0, 90, 70));
    EXPECT_EQ(far_.missing({{0.0, 0.0}, kFarZoom}, {0, 0, 900, 700}), QRegion(0, 0, 100, 75));
    QImage window = empty_window();
    far_.draw({{500.0, 500.0}, kFarZoom}, {0, 0, 20, 20}, window, pool());
    EXPECT_EQ(window, empty_window()) << "beside the canvas there is nothing to draw";
}

/// Ridges of paint about six cells apart, of another colour in each quarter.
std::shared_ptr<document::Snapshot> ridges(int width, int height) {
    auto snapshot = std::make_shared<document::Snapshot>();
    snapshot->film = film::FilmState({width, height}, 0.125);
    snapshot->ground = {0.90F, 0.92F, 0.91F, 0.88F, 0.86F, 0.85F};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double h_mm = 0.15 + 0.06 * std::sin(1.05 * x + 0.3 * y);
            snapshot->film.thickness.set(x, y,
                                         static_cast<std::int32_t>(h_mm / film::kThicknessQuantum_mm));
            film::PaintCell cell;
            const int quarter = (x > width / 2 ? 1 : 0) + (y > height / 2 ? 3 : 0);
            for (int k = 0; k < pigment::kChannels; ++k)
                cell[k] = static_cast<std::int32_t>((4 + 9 * ((k + quarter) % 5)) * h_mm /
                                                    film::kPaintQuantum);
            snapshot->film.paint.set(x, y, cell);
        }
    return snapshot;
}

class Afar : public testing::Test {
  protected:
    Afar() : scene_{{ridges(700, 500), {}, {}, {}, Look::Lit}, {}, kWindow_px, {}, {}} {
        scene_.ground = {0.2F, 0.2F, 0.2F};
        scene_.view = {{-15.0, -12.0}, 0.21};
    }

    /// As it is to be, however slow the machine is.
    static void show(RasterPicture& picture, const RasterScene& scene) {
        picture.show(scene, pool());
        while (picture.is_draft())
            picture.refine(pool());
    }
    static QImage shown(const RasterScene& scene) {
        RasterPicture picture;
        show(picture, scene);
        return picture.image();
    }
    void change(int x, int y) {
        auto next = std::make_shared<document::Snapshot>(*scene_.sight.painting);
        for (int j = 0; j < 9; ++j)
            for (int i = 0; i < 13; ++i)
                next->film.thickness.set(x + i, y + j, 5000 + 300 * i);
        scene_.sight.painting = next;
    }

    RasterScene scene_;
};

// The pictures are of 8 bits and dithered: a level for each of the two, and half of one for the samples,
// 1.5 cells apart at most, that the picture is a mean of.
TEST_F(Afar, ThePictureIsThatOfTheRenderer) {
    for (const double zoom : {0.25, 0.125}) {
        scene_.view = {{0.0, 0.0}, zoom};
        const QImage image = shown(scene_);
        shade::RenderSettings settings;
        settings.scale = zoom;
        const int width = static_cast<int>(kWindow_px.width() / zoom),
                  height = static_cast<int>(kWindow_px.height() / zoom);
        const document::Snapshot& painting = *scene_.sight.painting;
        const grid::Rect cells{0, 0, std::min(width, 696), std::min(height, 496)};
        const pigment::Image8 wanted = pigment::encode_srgb8(
            shade::render(painting.film, painting.ground, cells, settings, pool()));
        double sum = 0.0;
        int most = 0;
        for (int y = 1; y + 1 < wanted.height; ++y)
            for (int x = 1; x + 1 < wanted.width; ++x) {
                const std::uint8_t* rgb =
                    &wanted.rgb[3 * static_cast<std::size_t>(y * wanted.width + x)];
                const int differs = qGreen(image.pixel(x, y)) - rgb[1];
                most = std::max(most, std::abs(differs));
                sum += differs;
            }
        EXPECT_LE(most, 2) << zoom;
        EXPECT_NEAR(sum / (wanted.width * wanted.height), 0.0, 0.1) << zoom;
    }
}

TEST_F(Afar, WhatIsDrawnInPartsIsWhatIsDrawnAtOnce) {
    for (const double angle_deg : {0.0, 25.0}) {
        scene_.view.angle_deg = angle_deg;
        RasterPicture picture;
        show(picture, scene_);
        for (int step = 0; step < 4; ++step) {
            change(90 + 61 * step, 100 + 43 * step);
            show(picture, scene_);
            EXPECT_EQ(picture.image(), shown(scene_)) << step << " at " << angle_deg;
            scene_.view.zoom *= 0.83;
            show(picture, scene_);
            EXPECT_EQ(picture.image(), shown(scene_)) << step << " nearer or farther, at " << angle_deg;
        }
        scene_.view.zoom = 0.24;
    }
}

TEST_F(Afar, FromNearbyADraftEndsAsThePictureThatIsDrawnAtOnce) {
    for (const double zoom : {0.3, 0.55, 0.9}) {
        scene_.view = {{-15.0, -12.0}, zoom};
        RasterPicture picture;
        show(picture, scene_);
        for (int step = 0; step < 3; ++step) {
            change(90 + 61 * step, 100 + 43 * step);
            show(picture, scene_);
            EXPECT_EQ(picture.image(), shown(scene_)) << step << " at " << zoom;
        }
    }
}

TEST_F(Afar, PaintAndLightThatChangeWhileSeenFromNearbyAreThereFromAfar) {
    RasterPicture picture;
    show(picture, scene_);
    const ViewTransform afar = scene_.view;
    scene_.view = {{-200.0, -100.0}, 1.3};
    show(picture, scene_);
    change(200, 120);
    show(picture, scene_);
    scene_.view = afar;
    show(picture, scene_);
    EXPECT_EQ(picture.image(), shown(scene_));
    for (const auto turn :
         {+[](Sight& sight) { sight.lighting.azimuth_deg = 20.0; },
          +[](Sight& sight) { sight.lighting.ambient = 0.6; },
          +[](Sight& sight) { sight.lighting.specular = false; },
          +[](Sight& sight) { sight.look = Look::Flat; }, +[](Sight& sight) { sight.look = Look::Wet; },
          +[](Sight& sight) { sight.look = Look::Lit; }}) {
        turn(scene_.sight);
        show(picture, scene_);
        EXPECT_EQ(picture.image(), shown(scene_));
    }
    scene_.sight.painting = ridges(500, 700);
    show(picture, scene_);
    EXPECT_EQ(picture.image(), shown(scene_)) << "another canvas";
}

/// Moved by whole pixels: of a canvas that stands upright the kept pixels are those that would be made.
TEST_F(Afar, APictureThatIsMovedIsTheOneFromThere) {
    for (const double zoom : {0.21, 0.8, 2.0})
        for (const glm::dvec2& by : {glm::dvec2{7.0, 0.0}, {-3.0, 11.0}, {0.0, -200.0}, {30.0, 25.0}}) {
            scene_.view = {{-35.0, -22.0}, zoom};
            RasterPicture picture;
            show(picture, scene_);
            scene_.view.origin_px += by;
            show(picture, scene_);
            EXPECT_EQ(picture.image(), shown(scene_)) << zoom << ' ' << by.x << ' ' << by.y;
            change(250, 200);
            scene_.view.origin_px += by;
            show(picture, scene_);
            EXPECT_EQ(picture.image(), shown(scene_)) << "with other paint";
        }
}

TEST_F(Afar, DraftsMoveAlongAndAreRefined) {
    scene_.view = {{-300.0, -200.0}, 0.9};
    scene_.window_px = {700, 500};
    scene_.sight.painting = ridges(2000, 1500);
    RasterPicture picture;
    EXPECT_TRUE(picture.show(scene_, pool()));
    ASSERT_TRUE(picture.is_draft());
    scene_.view.origin_px += glm::dvec2{40.0, -30.0};
    show(picture, scene_);
    EXPECT_EQ(picture.image(), shown(scene_));
}

}  // namespace
}  // namespace pastoso::screen
