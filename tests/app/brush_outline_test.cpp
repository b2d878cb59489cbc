// What of the canvas the outline says that a brush touches.
#include "interactions/brush_outline.hpp"

#include "brush/brush.hpp"
#include "brush/stroke.hpp"
#include "core/units.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::interactions {
namespace {

struct Extent {
    glm::vec2 low{1e9F}, high{-1e9F};
    glm::vec2 size() const { return high - low; }
    glm::vec2 middle() const { return 0.5F * (low + high); }
};

Extent extent_of(const std::vector<glm::vec2>& line) {
    Extent extent;
    for (const glm::vec2& point : line) {
        extent.low = {std::min(extent.low.x, point.x), std::min(extent.low.y, point.y)};
        extent.high = {std::max(extent.high.x, point.x), std::max(extent.high.y, point.y)};
    }
    return extent;
}

brush::PenSample held(double pressure, double tilt_x_deg = 0.0, double tilt_y_deg = 0.0,
                      double rotation_deg = 0.0) {
    return {.pressure = pressure,
            .tilt_x_deg = tilt_x_deg,
            .tilt_y_deg = tilt_y_deg,
            .rotation_deg = rotation_deg};
}

TEST(BrushOutline, AnUprightFlatIsAsWideAsItsTipAndTurnsWithIt) {
    const BrushOutline outline(brush::find_preset("Flat bristle 20"));
    const glm::vec2 level = extent_of(outline.around_mm(held(0.5))).size();
    EXPECT_NEAR(level.x, 20.0, 5.0);
    EXPECT_GT(level.x, 2.0F * level.y);
    const glm::vec2 turned = extent_of(outline.around_mm(held(0.5, 0, 0, 90.0))).size();
    EXPECT_NEAR(turned.x, level.y, 0.3);
    EXPECT_NEAR(turned.y, level.x, 0.3);
}

TEST(BrushOutline, ARoundOnePressedHarderTouchesMore) {
    const BrushOutline outline(brush::find_preset("Round sable 9"));
    float before = 0.0F;
    for (const double pressure : {0.1, 0.3, 0.6, 1.0}) {
        const float width = extent_of(outline.around_mm(held(pressure))).size().x;
        EXPECT_GT(width, before);
        before = width;
    }
    EXPECT_GT(before, 7.0F);
}

/// A lean lowers one side: what touches moves towards it, and mirrored leans mirror it.
TEST(BrushOutline, MovesToTheSideThatLeanLowers) {
    const BrushOutline outline(brush::find_preset("Round bristle 12"));
    const auto middle = [&](double x_deg, double y_deg) {
        return extent_of(outline.around_mm(held(0.3, x_deg, y_deg))).middle();
    };
    const glm::vec2 upright = middle(0, 0);
    EXPECT_GT(middle(40, 0).x, upright.x + 1.0F);
    EXPECT_LT(middle(-40, 0).x, upright.x - 1.0F);
    EXPECT_GT(middle(0, 40).y, upright.y + 1.0F);
    EXPECT_NEAR(middle(40, 0).y, upright.y, 1.0F);
}

/// The brush is set down in one place and lifted: the paint lies within the outline, and reaches near
/// it. A footprint's radius and a cell beyond it there may lie a little.
TEST(BrushOutline, GoesAroundWhatThePaintCovers) {
    for (const double tilt_deg : {0.0, 35.0}) {
        brush::Preset preset = brush::find_preset("Filbert 14");
        brush::Brush brush(preset);
        brush.load(film::PaintCoefficients{}, 1.0);
        film::FilmState film({200, 200}, 0.25);
        brush::PenSample pen = held(0.6, tilt_deg, 0.0, 30.0);
        pen.x_mm = pen.y_mm = 25.0;
        brush::Stroke stroke(brush, film);
        stroke.begin(pen);
        stroke.end();
        Extent paint;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 200; ++x)
                if (film::thickness_mm(film.thickness.at(x, y)) > 0.0) {
                    const glm::vec2 place(0.25F * (x + 0.5F) - 25.0F, 0.25F * (y + 0.5F) - 25.0F);
                    paint.low = {std::min(paint.low.x, place.x), std::min(paint.low.y, place.y)};
                    paint.high = {std::max(paint.high.x, place.x), std::max(paint.high.y, place.y)};
                }
        const Extent outline = extent_of(BrushOutline(preset).around_mm(pen));
        EXPECT_NEAR(outline.low.x, paint.low.x, 1.5) << tilt_deg;
        EXPECT_NEAR(outline.low.y, paint.low.y, 1.5) << tilt_deg;
        EXPECT_NEAR(outline.high.x, paint.high.x, 1.5) << tilt_deg;
        EXPECT_NEAR(outline.high.y, paint.high.y, 1.5) << tilt_deg;
    }
}

TEST(BrushOutline, StaysThereWhereNothingTouches) {
    for (const brush::Preset& preset : brush::bundled_presets()) {
        for (const double pressure : {0.0, 0.5}) {
            const glm::vec2 size = extent_of(BrushOutline(preset).around_mm(held(pressure))).size();
            EXPECT_GT(size.x, 0.2F) << preset.name;
            EXPECT_LT(size.x, 3.0F * preset.tip.width_mm) << preset.name;
        }
    }
}

TEST(BrushOutline, DropsFallWithinACircle) {
    const brush::Preset preset = brush::find_preset("Spray can 35");
    const glm::vec2 size = extent_of(BrushOutline(preset).around_mm(held(0.5))).size();
    EXPECT_NEAR(size.x, size.y, 0.1);
    EXPECT_GT(size.x, 5.0F);
}

TEST(Hull, GoesAroundItsCircles) {
    const auto line = hull_mm({{0, 0}, {10, 0}, {5, 1}}, 2.0);
    const Extent extent = extent_of(line);
    EXPECT_NEAR(extent.low.x, -2.0, 1e-5);
    EXPECT_NEAR(extent.high.x, 12.0, 1e-5);
    EXPECT_NEAR(extent.low.y, -2.0, 1e-5);
    EXPECT_NEAR(extent.high.y, 3.0, 1e-5);
}

TEST(Handle, IsAsLongAsItsTiltAndPointsWhereItLeans) {
    EXPECT_EQ(handle_px(0, 0), glm::dvec2(0.0));
    EXPECT_EQ(handle_px(2, 2), glm::dvec2(0.0));
    const glm::dvec2 right = handle_px(30, 0);
    EXPECT_NEAR(right.x, 24.0, 1e-9);  // 48 sin 30
    EXPECT_EQ(right.y, 0.0);
    EXPECT_NEAR(handle_px(0, -60).y, -48.0 * std::sqrt(0.75), 1e-9);
    EXPECT_LT(glm::length(handle_px(10, 10)), glm::length(handle_px(40, 40)));
    EXPECT_NEAR(handle_px(90, 0).x, 48.0, 0.1);
}

}  // namespace
}  // namespace pastoso::interactions
