#include "view/masking_skin.hpp"

#include <QColor>
#include <gtest/gtest.h>

namespace pastoso::view {
namespace {

document::Masking masking_of(grid::Mask cells) {
    return {std::make_shared<const grid::Mask>(std::move(cells))};
}

TEST(MaskingSkin, IsThereWhereTheCanvasIsMasked) {
    grid::Mask cells({7, 3});
    cells.set(4, 1, grid::kWhole);
    MaskingSkin skin;
    const QImage picture = skin.picture(masking_of(cells));
    ASSERT_EQ(picture.size(), QSize(7, 3));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 7; ++x)
            EXPECT_EQ(qAlpha(picture.pixel(x, y)) > 0, x == 4 && y == 1) << x << ", " << y;
    EXPECT_LT(qAlpha(picture.pixel(4, 1)), 200) << "paint shows through";
    EXPECT_TRUE(skin.picture({}).isNull());
}

TEST(MaskingSkin, OfALargeCanvasIsCoarser) {
    grid::Mask cells({5000, 10});
    for (int x = 2500; x < 5000; ++x)
        for (int y = 0; y < 10; ++y)
            cells.set(x, y, grid::kWhole);
    MaskingSkin skin;
    const QImage picture = skin.picture(masking_of(cells));
    EXPECT_EQ(picture.size(), QSize(1667, 4));
    EXPECT_EQ(qAlpha(picture.pixel(800, 2)), 0);
    EXPECT_GT(qAlpha(picture.pixel(900, 2)), 0);
}

/// Of what is drawn on white.
QColor on_white(const QImage& picture, int x, int y) {
    const QRgb pixel = picture.pixel(x, y);
    const auto channel = [&](int premultiplied) { return premultiplied + 255 - qAlpha(pixel); };
    return QColor(channel(qRed(pixel)), channel(qGreen(pixel)), channel(qBlue(pixel)));
}

/// A square of 40 from 10 on.
document::Masking square(bool tape) {
    grid::Mask cells({64, 64});
    for (int y = 10; y < 50; ++y)
        for (int x = 10; x < 50; ++x)
            cells.set(x, y, grid::kWhole);
    document::Masking masking = masking_of(cells);
    if (tape) masking.tape = masking.cells;
    return masking;
}

TEST(MaskingSkin, FluidIsBluishAndTapeIsWarm) {
    MaskingSkin skin;
    const QColor fluid = on_white(skin.picture(square(false)), 30, 30);
    EXPECT_GT(fluid.blue(), fluid.red() + 10);
    const QColor tape = on_white(skin.picture(square(true)), 30, 30);
    EXPECT_GT(tape.red(), tape.blue() + 25);
}

TEST(MaskingSkin, FluidIsRoundedAndShinesTowardsTheUpperLeft) {
    MaskingSkin skin;
    const QImage picture = skin.picture(square(false));
    EXPECT_LT(qAlpha(picture.pixel(10, 30)), qAlpha(picture.pixel(11, 30)));
    EXPECT_LT(qAlpha(picture.pixel(11, 30)), qAlpha(picture.pixel(13, 30)));
    EXPECT_GT(qBlue(picture.pixel(11, 30)), qBlue(picture.pixel(48, 30)) + 20);
    EXPECT_EQ(picture.pixel(20, 30), picture.pixel(30, 20)) << "even within";
}

TEST(MaskingSkin, TapeHasAnEdgeAndFibresAlong) {
    MaskingSkin skin;
    const QImage picture = skin.picture(square(true));
    EXPECT_EQ(qAlpha(picture.pixel(10, 30)), qAlpha(picture.pixel(30, 30)));
    EXPECT_LT(on_white(picture, 10, 30).red(), on_white(picture, 12, 30).red());
    int along = 0, across = 0;
    for (int i = 12; i < 47; ++i) {
        along += picture.pixel(i, 30) != picture.pixel(i + 1, 30) ? 1 : 0;
        across += picture.pixel(30, i) != picture.pixel(30, i + 1) ? 1 : 0;
    }
    EXPECT_LE(along, 2);
    EXPECT_GT(across, 20);
}

TEST(MaskingSkin, FluidBesideTapeHasAnEdgeOfItsOwn) {
    document::Masking masking = square(false);
    grid::Mask tape({64, 64});
    for (int y = 10; y < 50; ++y)
        for (int x = 30; x < 50; ++x)
            tape.set(x, y, grid::kWhole);
    masking.tape = std::make_shared<const grid::Mask>(tape);
    MaskingSkin skin;
    const QImage picture = skin.picture(masking);
    EXPECT_LT(qAlpha(picture.pixel(29, 30)), qAlpha(picture.pixel(25, 30)));
    EXPECT_GT(on_white(picture, 35, 30).red(), on_white(picture, 35, 30).blue());
}

}  // namespace
}  // namespace pastoso::view
