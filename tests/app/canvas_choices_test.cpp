// The canvases that one click puts up.
#include "start/canvas_choices.hpp"

#include "dialogs/support_choices.hpp"
#include "document/actions/actions.hpp"
#include "document/canvas.hpp"
#include "film/support/support.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::start {
namespace {

TEST(CanvasChoices, EverySizeIsACanvasThatStaysQuick) {
    std::set<QString> names;
    for (const CanvasSize& size : canvas_sizes()) {
        EXPECT_TRUE(names.insert(size.name).second) << size.name.toStdString();
        EXPECT_GE(size.longer_mm, size.shorter_mm);
        const document::CanvasSettings canvas = canvas_of(size, false, "linen");
        EXPECT_NO_THROW(document::check_canvas(canvas));
        const grid::Shape shape = document::canvas_shape(canvas);
        EXPECT_LE(shape.width * shape.height, 4'000'000) << size.name.toStdString();
        EXPECT_GE(shape.width, 800) << size.name.toStdString();
    }
}

TEST(CanvasChoices, EverySupportIsOneOfTheEngines) {
    core::ThreadPool pool(1);
    for (const dialogs::Support& support : dialogs::supports()) {
        document::CanvasSettings canvas{.width_mm = 10.0, .height_mm = 10.0};
        canvas.support = support.id;
        EXPECT_NO_THROW(document::named_support(canvas, pool)) << support.id;
    }
}

TEST(CanvasChoices, UprightStandsOnTheShorterSide) {
    const CanvasSize a4{QStringLiteral("A4"), 297.0, 210.0};
    const document::CanvasSettings upright = canvas_of(a4, true, "panel");
    EXPECT_EQ(upright.width_mm, 210.0);
    EXPECT_EQ(upright.height_mm, 297.0);
    EXPECT_EQ(upright.support, "panel");
    EXPECT_EQ(canvas_of(a4, false, "panel").width_mm, 297.0);
}

TEST(CanvasChoices, TheFinerTheSmaller) {
    EXPECT_EQ(sensible_px_per_mm(297.0, 210.0), 4.0);
    EXPECT_EQ(sensible_px_per_mm(20.0, 20.0), 8.0);
    EXPECT_EQ(sensible_px_per_mm(2000.0, 1000.0), 3.0);
}

TEST(CanvasChoices, ScreensHaveTheirPixels) {
    const auto sizes = canvas_sizes();
    const auto screen = std::find_if(sizes.begin(), sizes.end(), [](const CanvasSize& size) {
        return size.name == QStringLiteral("Screen, QHD");
    });
    ASSERT_NE(screen, sizes.end());
    const grid::Shape shape = document::canvas_shape(canvas_of(*screen, true, "linen"));
    EXPECT_EQ(shape.width, 1440);
    EXPECT_EQ(shape.height, 2560);
}

}  // namespace
}  // namespace pastoso::start
