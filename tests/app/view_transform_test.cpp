#include "view/view_transform.hpp"

#include "core/random.hpp"

#include <gtest/gtest.h>

namespace pastoso::view {
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

}  // namespace
}  // namespace pastoso::view
