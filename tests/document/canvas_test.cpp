#include "document/canvas.hpp"

#include "document/error_of.hpp"

#include <cmath>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

CanvasSettings canvas_of(double width_mm, double height_mm, double px_per_mm) {
    CanvasSettings canvas;
    canvas.width_mm = width_mm;
    canvas.height_mm = height_mm;
    canvas.px_per_mm = px_per_mm;
    return canvas;
}

std::string error(const CanvasSettings& canvas) {
    return error_of([&] { check_canvas(canvas); });
}

TEST(Canvas, CountsWholeCells) {
    EXPECT_EQ(canvas_shape(canvas_of(300, 200, 4)), (grid::Shape{1200, 800}));
    EXPECT_EQ(canvas_shape(canvas_of(10.3, 1, 2.5)), (grid::Shape{26, 3}));
    EXPECT_EQ(canvas_shape(canvas_of(1, 1, 0.25)), (grid::Shape{1, 1}));
}

TEST(Canvas, RefusesSizesThatAreNoSizes) {
    EXPECT_EQ(error(canvas_of(300, 200, 4)), "");
    EXPECT_EQ(error(canvas_of(0, 200, 4)),
              "The width of the canvas is 0 mm, but must lie between 1 and 5000.");
    EXPECT_THAT(error(canvas_of(300, -1, 4)), HasSubstr("The height of the canvas is -1 mm"));
    EXPECT_THAT(error(canvas_of(300, 200, 0)), HasSubstr("The resolution of the canvas is 0 px/mm"));
    EXPECT_THAT(error(canvas_of(NAN, 200, 4)), HasSubstr("The width of the canvas is nan mm"));
    EXPECT_THAT(error(canvas_of(300, INFINITY, 4)), HasSubstr("The height of the canvas is inf mm"));
}

TEST(Canvas, RefusesMoreCellsThanASideMayHave) {
    EXPECT_EQ(
        error(canvas_of(2000, 10, 20)),
        "A canvas of 2000 x 10 mm at 20 px/mm would have 40000 x 200 pixels; at most 32768 a side are "
        "possible.");
}

TEST(Canvas, RefusesWhatDoesNotFitIntoMemory) {
    const CanvasSettings canvas = canvas_of(300, 200, 4);
    const std::size_t needed = estimated_bytes(canvas_shape(canvas));
    EXPECT_EQ(error_of([&] { check_canvas_fits(canvas, needed); }), "");
    EXPECT_EQ(error_of([&] { check_canvas_fits(canvas, needed - 1); }),
              "A canvas of 300 x 200 mm at 4 px/mm needs about 0.3 GiB; 0.3 GiB of memory are free.");
}

TEST(Canvas, NeedsMoreForMoreCells) {
    EXPECT_EQ(estimated_bytes({128, 64}), 2 * estimated_bytes({64, 64}));
    EXPECT_EQ(estimated_bytes({1, 1}), estimated_bytes({64, 64}));
}

}  // namespace
}  // namespace pastoso::document
