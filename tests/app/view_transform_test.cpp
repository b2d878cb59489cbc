#include "screen/view_transform.hpp"

#include "core/random.hpp"
#include "core/units.hpp"
#include "screen/damaged_pixels.hpp"
#include "view/turned_pen.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::screen {
namespace {

/// A pixel's millionth: room for rounding in double precision alone.
constexpr double kTiny = 1e-6;

void expect_near(const glm::dvec2& a, const glm::dvec2& b, double tolerance = kTiny) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(ViewTransform, CellsAndPixelsAreInverse) {
    const ViewTransform view{{-312.5, 47.25}, 3.75};
    expect_near(view.cell_from_device(view.device_from_cell({12.5, -7.0})), {12.5, -7.0});
    expect_near(view.device_from_cell({0.0, 0.0}), {-312.5, 47.25});
    expect_near(view.device_from_cell({2.0, 4.0}) - view.device_from_cell({1.0, 1.0}), {3.75, 11.25});
}

TEST(ViewTransform, ZoomKeepsThePointUnderTheCursor) {
    ViewTransform view{{10.0, 20.0}, 0.8};
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::dvec2 anchor{1280.0 * core::uniform_noise(i, 1), 800.0 * core::uniform_noise(i, 2)};
        const glm::dvec2 before = view.cell_from_device(anchor);
        view = zoomed(view, anchor, core::uniform_noise(i, 3) < 0.5F ? 1.25 : 0.8);
        expect_near(view.cell_from_device(anchor), before);
    }
}

TEST(ViewTransform, ZoomStopsAtItsLimits) {
    const ViewTransform view{{0.0, 0.0}, 1.0};
    EXPECT_DOUBLE_EQ(zoomed(view, {5.0, 5.0}, 1e6).zoom, kLargestZoom);
    EXPECT_DOUBLE_EQ(zoomed(view, {5.0, 5.0}, 1e-6).zoom, kSmallestZoom);
    // At the limit the picture stands still instead of sliding away.
    const ViewTransform closest = zoomed(view, {5.0, 5.0}, 1e6);
    EXPECT_EQ(zoomed(closest, {400.0, 300.0}, 2.0), closest);
}

TEST(ViewTransform, FitShowsTheWholeCanvasInTheMiddle) {
    const glm::dvec2 canvas{1200.0, 800.0};
    const glm::dvec2 window{1000.0, 700.0};
    const ViewTransform view = fitted(canvas, window, 24.0);
    EXPECT_DOUBLE_EQ(view.zoom, (1000.0 - 48.0) / 1200.0);
    // The origin is on whole pixels, so the centre is off by half a pixel at most.
    expect_near(view.device_from_cell(0.5 * canvas), 0.5 * window, 0.5);
}

TEST(ViewTransform, FitOfAnyShapeStaysWithinTheWindow) {
    for (const glm::dvec2 canvas :
         {glm::dvec2{8.0, 5000.0}, glm::dvec2{3000.0, 40.0}, glm::dvec2{64.0, 64.0}}) {
        const ViewTransform view = fitted(canvas, {640.0, 480.0}, 24.0);
        const glm::dvec2 first = view.device_from_cell({0.0, 0.0});
        const glm::dvec2 last = view.device_from_cell(canvas);
        EXPECT_GE(std::min(first.x, first.y), 0.0);
        EXPECT_LE(last.x, 640.0);
        EXPECT_LE(last.y, 480.0);
    }
}

TEST(ViewTransform, PanNeverLosesTheCanvas) {
    const glm::dvec2 canvas{100.0, 80.0};
    const glm::dvec2 window{640.0, 480.0};
    const ViewTransform view{{200.0, 200.0}, 2.0};
    expect_near(panned(view, {30.0, -12.0}, canvas, window).origin_px, {230.0, 188.0});
    expect_near(panned(view, {1e5, 1e5}, canvas, window, 48.0).origin_px, window - 48.0);
    expect_near(panned(view, {-1e5, -1e5}, canvas, window, 48.0).origin_px, 48.0 - 2.0 * canvas);
}

/// Of any place, zoom, angle and side.
ViewTransform any_view(std::uint32_t seed) {
    const auto noise = [&](std::uint32_t i) {
        return static_cast<double>(core::uniform_noise(seed, i));
    };
    return {.origin_px = {2000.0 * noise(1) - 1000.0, 2000.0 * noise(2) - 1000.0},
            .zoom = std::exp2(8.0 * noise(3) - 4.0),
            .angle_deg = 360.0 * noise(4) - 180.0,
            .mirrored = noise(5) < 0.5};
}

glm::dvec2 any_place(std::uint32_t seed) {
    return {1000.0 * core::uniform_noise(seed, 11), 1000.0 * core::uniform_noise(seed, 12)};
}

TEST(ViewTransform, CellsAndPixelsAreInverseHoweverItIsTurned) {
    for (std::uint32_t i = 0; i < 500; ++i) {
        const ViewTransform view = any_view(i);
        const glm::dvec2 place = any_place(i);
        expect_near(view.cell_from_device(view.device_from_cell(place)), place);
        expect_near(view.device_from_cell(view.cell_from_device(place)), place);
    }
}

TEST(ViewTransform, QuarterTurnsAreExact) {
    const ViewTransform upright{{8.0, 16.0}, 2.0};
    const glm::dvec2 cell{3.0, 5.0};
    const auto at = [&](double angle_deg, bool mirrored) {
        return ViewTransform{{8.0, 16.0}, 2.0, angle_deg, mirrored}.device_from_cell(cell);
    };
    EXPECT_EQ(at(0.0, false), upright.device_from_cell(cell));
    EXPECT_EQ(at(90.0, false), glm::dvec2(8.0 - 10.0, 16.0 + 6.0));
    EXPECT_EQ(at(180.0, false), glm::dvec2(8.0 - 6.0, 16.0 - 10.0));
    EXPECT_EQ(at(-90.0, false), glm::dvec2(8.0 + 10.0, 16.0 - 6.0));
    EXPECT_EQ(at(0.0, true), glm::dvec2(8.0 - 6.0, 16.0 + 10.0));
    EXPECT_EQ(at(90.0, true), glm::dvec2(8.0 - 10.0, 16.0 - 6.0));
}

TEST(ViewTransform, TurningKeepsThePointInTheMiddle) {
    const glm::dvec2 middle{320.0, 240.0};
    for (std::uint32_t i = 0; i < 200; ++i) {
        const ViewTransform view = any_view(i);
        const double by_deg = 700.0 * core::uniform_noise(i, 20) - 350.0;
        const ViewTransform next = turned(view, middle, by_deg);
        expect_near(next.cell_from_device(middle), view.cell_from_device(middle));
        EXPECT_NEAR(std::remainder(next.angle_deg - view.angle_deg - by_deg, 360.0), 0.0, 1e-9);
        EXPECT_GT(next.angle_deg, -180.0);
        EXPECT_LE(next.angle_deg, 180.0);
    }
}

TEST(ViewTransform, StepsAroundACircleComeBackToWholePixels) {
    const ViewTransform start{{17.0, 30.0}, 1.0};
    ViewTransform view = start;
    for (int step = 1; step <= 24; ++step) {
        view = turned(view, {320.0, 240.5}, 15.0);
        if (step % 6 == 0) {
            EXPECT_EQ(view.origin_px,
                      glm::dvec2(std::round(view.origin_px.x), std::round(view.origin_px.y)));
        }
    }
    EXPECT_EQ(view.angle_deg, 0.0);
    // Of an odd height the middle is no whole pixel: half of one is lost at every quarter.
    expect_near(view.origin_px, start.origin_px, 2.0);
}

TEST(ViewTransform, AMirrorChangesLeftAndRightOfTheWindow) {
    const glm::dvec2 window{641.0, 480.0};
    for (std::uint32_t i = 0; i < 200; ++i) {
        const ViewTransform view = any_view(i);
        const ViewTransform other = mirrored(view, window);
        const glm::dvec2 place = any_place(i), there = view.device_from_cell(place);
        expect_near(other.device_from_cell(place), {window.x - there.x, there.y});
        expect_near(mirrored(other, window).device_from_cell(place), there);
    }
}

TEST(ViewTransform, FingersKeepWhatLiesBelowThem) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        ViewTransform view = any_view(i);
        view.zoom = 1.0 + core::uniform_noise(i, 30);  // far from the limits
        const Fingers from{any_place(3 * i), any_place(3 * i + 1)};
        const glm::dvec2 way = 0.2 * any_place(3 * i + 2);
        const Fingers to{from[0] + way, from[1] - 0.5 * way};
        const ViewTransform next = pinched(view, from, to);
        for (int finger = 0; finger < 2; ++finger)
            expect_near(next.cell_from_device(to[finger]), view.cell_from_device(from[finger]), 1e-5);
        EXPECT_EQ(pinched(view, from, to, false).angle_deg, view.angle_deg);
    }
    const ViewTransform view = any_view(1);
    EXPECT_EQ(pinched(view, {glm::dvec2(5.0), glm::dvec2(5.0)}, {glm::dvec2(1.0), glm::dvec2(9.0)}),
              view);
}

TEST(ViewTransform, FitAndPanHoldHoweverItIsTurned) {
    const glm::dvec2 canvas{900.0, 500.0}, window{640.0, 480.0};
    for (std::uint32_t i = 0; i < 200; ++i) {
        const ViewTransform view = any_view(i);
        const ViewTransform fit = fitted(canvas, window, 24.0, view);
        const DeviceBox whole = device_box(fit, {0.0, 0.0}, canvas);
        expect_near(0.5 * (whole.low + whole.high), 0.5 * window, 0.75);  // on whole pixels
        EXPECT_GE(std::min(whole.low.x, whole.low.y), 23.0);
        EXPECT_EQ(fit.angle_deg, view.angle_deg);
        EXPECT_EQ(fit.mirrored, view.mirrored);
        const DeviceBox left = device_box(panned(view, {1e6, -1e6}, canvas, window), {0.0, 0.0}, canvas);
        EXPECT_NEAR(left.low.x, window.x - 48.0, kTiny);
        EXPECT_NEAR(left.high.y, 48.0, kTiny);
    }
}

TEST(DamagedPixels, HoldTheWholePictureOfTheCellsAndLittleElse) {
    const QRect cells(300, 200, 600, 8);
    for (std::uint32_t i = 0; i < 100; ++i) {
        ViewTransform view = any_view(i);
        view.zoom = 1.0;
        const QRegion region = damaged_pixels(view, cells);
        for (std::uint32_t j = 0; j < 100; ++j) {
            const glm::dvec2 cell{300.0 + 600.0 * core::uniform_noise(j, 1),
                                  200.0 + 8.0 * core::uniform_noise(j, 2)};
            const glm::dvec2 px = view.device_from_cell(cell);
            EXPECT_TRUE(region.contains(
                QPoint(static_cast<int>(std::floor(px.x)), static_cast<int>(std::floor(px.y)))));
        }
        double area = 0.0;
        for (const QRect& part : region)
            area += static_cast<double>(part.width()) * part.height();
        // 604 x 12 pixels, a strip's height more on both sides where it is steepest: not 300,000.
        EXPECT_LT(area, 604.0 * 12.0 * 8.0);
    }
}

TEST(TurnedPen, AnUprightCanvasChangesNothing) {
    tools::Pointer pointer;
    pointer.tilt_x_deg = 25.0;
    pointer.tilt_y_deg = -90.0;
    pointer.rotation_deg = 200.0;
    const tools::Pointer same = view::against_canvas({{3.0, 4.0}, 2.0}, pointer);
    EXPECT_EQ(same.tilt_x_deg, 25.0);
    EXPECT_EQ(same.tilt_y_deg, -90.0);
    EXPECT_EQ(same.rotation_deg, 200.0);
    EXPECT_EQ(same.hand_deg, 0.0);
}

/// The way of the pen's lean, and of the tip's width, over the canvas and on the screen.
TEST(TurnedPen, LeansAndTurnsAsItDoesOnTheScreen) {
    const auto direction = [](double angle_deg) {
        return glm::dvec2(std::cos(core::radians(angle_deg)), std::sin(core::radians(angle_deg)));
    };
    const auto lean = [](const tools::Pointer& pen) {
        return glm::dvec2(std::tan(core::radians(pen.tilt_x_deg)),
                          std::tan(core::radians(pen.tilt_y_deg)));
    };
    for (std::uint32_t i = 0; i < 200; ++i) {
        const ViewTransform view = any_view(i);
        tools::Pointer pen;
        pen.tilt_x_deg = 120.0 * core::uniform_noise(i, 40) - 60.0;
        pen.tilt_y_deg = 120.0 * core::uniform_noise(i, 41) - 60.0;
        pen.rotation_deg = 360.0 * core::uniform_noise(i, 42);
        const tools::Pointer there = view::against_canvas(view, pen);
        expect_near(view.axes() * lean(there), lean(pen));
        expect_near(view.axes() * direction(*there.rotation_deg), direction(*pen.rotation_deg));
        expect_near(view.axes() * direction(there.hand_deg), direction(pen.hand_deg));
    }
}

}  // namespace
}  // namespace pastoso::screen
