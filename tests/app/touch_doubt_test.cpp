// Where a stroke that begins may change nothing.
#include "tools/touch_doubt.hpp"

#include "document/painting.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using namespace document;

/// A canvas of 40 x 30 mm with a wet stripe along y = 8 mm, and a brush that holds paint.
class TouchDoubt : public testing::Test {
  protected:
    TouchDoubt() {
        painting.apply(TakeBrush{"flat", 8, 1});
        painting.apply(LoadPaint{.paint = {{{"PB29", 1.0}}, 1.0}});
        painting.apply(PenDown{{0.0, 10.0, 8.0, 0.5}});
        for (int i = 1; i <= 20; ++i)
            painting.apply(PenMove{{0.01 * i, 10.0 + i, 8.0, 0.5}});
        painting.apply(PenUp{});
        painting.apply(LoadPaint{.paint = {{{"PB29", 1.0}}, 1.0}});
    }
    bool may_touch_nothing_at(double x_mm, double y_mm) {
        return may_touch_nothing(painting.snapshot(), x_mm, y_mm);
    }

    core::ThreadPool pool{1};
    Painting painting{{.width_mm = 40.0, .height_mm = 30.0, .px_per_mm = 2.0, .support = "panel"}, pool};
};

TEST_F(TouchDoubt, APaintedBrushPaintsOnTheCanvasAlone) {
    EXPECT_FALSE(may_touch_nothing_at(20.0, 8.0));
    EXPECT_FALSE(may_touch_nothing_at(0.1, 29.9));
    EXPECT_TRUE(may_touch_nothing_at(-0.1, 8.0));
    EXPECT_TRUE(may_touch_nothing_at(40.1, 8.0));
    EXPECT_TRUE(may_touch_nothing_at(20.0, 30.1));
}

TEST_F(TouchDoubt, ADryBrushFindsSomethingInWetPaintAlone) {
    painting.apply(TakeBrush{"flat", 8, 2});
    EXPECT_FALSE(may_touch_nothing_at(20.0, 8.0));
    EXPECT_TRUE(may_touch_nothing_at(20.0, 25.0));
    painting.apply(DryNow{});
    EXPECT_TRUE(may_touch_nothing_at(20.0, 8.0));
}

TEST_F(TouchDoubt, WhatIsNotSelectedStaysAsItIs) {
    painting.apply(SelectArea{{{0, 0}, {15, 0}, {15, 30}, {0, 30}}});
    EXPECT_FALSE(may_touch_nothing_at(12.0, 20.0));
    EXPECT_TRUE(may_touch_nothing_at(20.0, 8.0));
}

TEST_F(TouchDoubt, WhatIsMaskedStaysAsItIs) {
    painting.apply(MaskStripe{{{0, 8}, {40, 8}}, 4});
    EXPECT_TRUE(may_touch_nothing_at(20.0, 8.0));
    EXPECT_FALSE(may_touch_nothing_at(20.0, 20.0));
}

TEST_F(TouchDoubt, WhereBareIsLockedPaintIsNeeded) {
    painting.apply(SetLayer{1, {.name = "Locked", .bare_locked = true}});
    EXPECT_FALSE(may_touch_nothing_at(20.0, 8.0));
    EXPECT_TRUE(may_touch_nothing_at(20.0, 25.0));
}

}  // namespace
}  // namespace pastoso::tools
