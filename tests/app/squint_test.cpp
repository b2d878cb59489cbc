#include "screen/squint.hpp"

#include "pigment/colour.hpp"
#include "screen/encoded_pixels.hpp"

#include <cmath>

#include <QRgba64>
#include <gtest/gtest.h>

namespace pastoso::screen {
namespace {

QImage even(int width, int height, const QRgba64& pixel) {
    QImage picture(width, height, QImage::Format_RGBA64);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            reinterpret_cast<QRgba64*>(picture.scanLine(y))[x] = pixel;
    return picture;
}

QRgba64& pixel(QImage& picture, int x, int y) {
    return reinterpret_cast<QRgba64*>(picture.scanLine(y))[x];
}

/// What was seen before the contrast was lowered, as light.
double light_at(QImage& picture, int x, int y) {
    const double encoded = (pixel(picture, x, y).red() / kMost16 - 0.5) / kSquintContrast + 0.5;
    return pigment::decode_srgb(std::max(encoded, 0.0));
}

QImage squinted(const QImage& picture, double blur_px) {
    core::ThreadPool pool(2);
    return screen::squinted(picture, blur_px, pool);
}

TEST(Squint, LeavesAnEvenPictureEven) {
    QImage seen = squinted(even(13, 7, qRgba64(0, 32768, 65535, 20000)), 6.0);
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 13; ++x) {
            // 12 bits of light, read back through its curve.
            EXPECT_NEAR(pixel(seen, x, y).red() / kMost16, 0.125, 2e-4);
            EXPECT_NEAR(pixel(seen, x, y).green() / kMost16, 0.5, 4e-4);
            EXPECT_NEAR(pixel(seen, x, y).blue() / kMost16, 0.875, 2e-4);
            EXPECT_NEAR(pixel(seen, x, y).alpha(), 20000, 1);
        }
    }
}

TEST(Squint, MixesLightAndNotItsNumbers) {
    QImage board = even(64, 64, qRgba64(0, 0, 0, 65535));
    for (int y = 0; y < 64; ++y)
        for (int x = y % 2; x < 64; x += 2)
            pixel(board, x, y) = qRgba64(65535, 65535, 65535, 65535);
    QImage seen = squinted(board, 5.0);
    EXPECT_NEAR(light_at(seen, 31, 20), 0.5, 1e-3);
}

TEST(Squint, SpreadsLightByTheBlurAndKeepsAllOfIt) {
    constexpr int kSide = 120;
    constexpr double kBlur_px = 9.0;
    QImage spot = even(kSide, kSide, qRgba64(0, 0, 0, 65535));
    for (int y = 60; y < 64; ++y)
        for (int x = 60; x < 64; ++x)
            pixel(spot, x, y) = qRgba64(65535, 65535, 65535, 65535);
    QImage seen = squinted(spot, kBlur_px);
    double sum = 0.0, mean = 0.0, square = 0.0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double light = light_at(seen, x, y), from_middle = x - 61.5;
            sum += light;
            mean += light * from_middle;
            square += light * from_middle * from_middle;
        }
    }
    // Encoded values of squares are interpolated, not light; the tails end at three deviations.
    EXPECT_NEAR(sum, 16.0, 0.5);
    EXPECT_NEAR(mean / sum, 0.0, 1e-3);
    EXPECT_NEAR(std::sqrt(square / sum), kBlur_px, 0.05 * kBlur_px);
}

TEST(Squint, SeesAMirroredPictureMirrored) {
    QImage picture = even(40, 24, qRgba64(3000, 3000, 3000, 65535));
    for (int y = 4; y < 15; ++y)
        for (int x = 2; x < 19; ++x)
            pixel(picture, x, y) = qRgba64(60000, 20000, 1000, 30000);
    QImage seen = squinted(picture, 5.0);
    QImage of_mirrored = squinted(picture.mirrored(true, false), 5.0);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x)
            EXPECT_NEAR(pixel(of_mirrored, 39 - x, y).red(), pixel(seen, x, y).red(), 1)
                << x << ", " << y;
}

TEST(Squint, WeightsAreOneTogether) {
    for (const double blur_px : {0.5, 1.9, 2.5, 7.6, 60.0, 500.0}) {
        const std::vector<float> weights = squint_weights(blur_px);
        double sum = -weights[0];
        for (const float weight : weights)
            sum += 2.0 * static_cast<double>(weight);
        EXPECT_NEAR(sum, 1.0, 1e-6) << blur_px;
        EXPECT_LE(weights.size(), 32U) << "what the shader has room for";
    }
    EXPECT_EQ(squint_weights(1.9).size(), 1U);
}

}  // namespace
}  // namespace pastoso::screen
