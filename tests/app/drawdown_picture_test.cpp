#include "panels/paint/drawdown_picture.hpp"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

namespace pastoso::panels {
namespace {

using pigment::Hiding;

/// Dark pixels of a mark on white.
int ink(Hiding hiding) {
    QImage picture(16, 16, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    draw_hiding_mark(painter, {3.5, 3.5, 8.0, 8.0}, hiding, Qt::black);
    painter.end();
    int dark = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            dark += picture.pixelColor(x, y).value() < 100 ? 1 : 0;
    return dark;
}

TEST(HidingMark, IsFullerTheBetterThePaintHides) {
    const int outline = ink(Hiding::Transparent);
    EXPECT_GT(outline, 20);
    EXPECT_GT(ink(Hiding::SemiTransparent), outline);
    EXPECT_GT(ink(Hiding::SemiOpaque), ink(Hiding::SemiTransparent));
    EXPECT_GT(ink(Hiding::Opaque), ink(Hiding::SemiOpaque));
}

TEST(DrawdownPicture, HasWhiteAboveBlackAndTheFilmInHandOnTheLeft) {
    tools::Drawdown drawdown;
    for (std::uint8_t step = 0; step < tools::Drawdown::kSteps; ++step) {
        drawdown.over_white[step] = {200, step, 0};
        drawdown.over_black[step] = {50, step, 0};
    }
    QImage picture(32, 10, QImage::Format_RGB32);
    QPainter painter(&picture);
    draw_drawdown(painter, picture.rect(), drawdown);
    painter.end();
    for (int x = 0; x < picture.width(); ++x) {
        EXPECT_EQ(picture.pixelColor(x, 0), QColor(200, x / 4, 0));
        EXPECT_EQ(picture.pixelColor(x, 9), QColor(50, x / 4, 0));
    }
}

}  // namespace
}  // namespace pastoso::panels
