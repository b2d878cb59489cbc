// The canvases that one click puts up.
#include "start/canvas_choices.hpp"

#include "dialogs/support_choices.hpp"
#include "document/actions/actions.hpp"
#include "document/canvas.hpp"
#include "document/cloth.hpp"
#include "film/support/support.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::start {
namespace {

/// Keeps pace with 8 cells a millimetre, and has 6 GiB free.
constexpr Machine kCommon{8.0, std::size_t{6} << 30};

TEST(CanvasChoices, EverySizeIsACanvasThatStaysQuick) {
    std::set<QString> names;
    for (const CanvasSize& size : canvas_sizes()) {
        EXPECT_TRUE(names.insert(size.name).second) << size.name.toStdString();
        EXPECT_GE(size.longer_mm, size.shorter_mm);
        const document::CanvasSettings canvas = canvas_of(size, false, "linen", kCommon);
        EXPECT_NO_THROW(document::check_canvas(canvas));
        const grid::Shape shape = document::canvas_shape(canvas);
        EXPECT_LE(document::estimated_bytes(shape), kCommon.memory_bytes / 3) << size.name.toStdString();
        EXPECT_LE(canvas.px_per_mm, kCommon.live_px_per_mm) << size.name.toStdString();
        EXPECT_GE(shape.width, 800) << size.name.toStdString();
    }
}

TEST(CanvasChoices, EverySupportIsOneOfTheEngines) {
    core::ThreadPool pool(1);
    for (const dialogs::Support& support : dialogs::supports()) {
        document::CanvasSettings canvas{.width_mm = 10.0, .height_mm = 10.0};
        canvas.support = support.id;
        EXPECT_NO_THROW(document::heights_of_cloth(canvas, pool)) << support.id;
    }
}

TEST(CanvasChoices, UprightStandsOnTheShorterSide) {
    const CanvasSize a4{QStringLiteral("A4"), 297.0, 210.0};
    const document::CanvasSettings upright = canvas_of(a4, true, "panel", kCommon);
    EXPECT_EQ(upright.width_mm, 210.0);
    EXPECT_EQ(upright.height_mm, 297.0);
    EXPECT_EQ(upright.support, "panel");
    EXPECT_EQ(canvas_of(a4, false, "panel", kCommon).width_mm, 297.0);
}

TEST(CanvasChoices, TheFinerTheSmaller) {
    constexpr Machine kSlow{4.0, std::size_t{6} << 30};
    EXPECT_EQ(sensible_px_per_mm(297.0, 210.0, kSlow), 4.0);
    EXPECT_EQ(sensible_px_per_mm(20.0, 20.0, kSlow), 8.0);
    EXPECT_EQ(sensible_px_per_mm(2000.0, 1000.0, kSlow), 3.0);
}

TEST(CanvasChoices, FinerWhereTheMachineKeepsPaceAndHasTheMemory) {
    EXPECT_EQ(sensible_px_per_mm(297.0, 210.0, kCommon), 8.0);
    EXPECT_EQ(sensible_px_per_mm(297.0, 210.0, {6.0, kCommon.memory_bytes}), 6.0);
    const double on_little = sensible_px_per_mm(420.0, 297.0, {8.0, kCommon.memory_bytes / 2});
    EXPECT_LT(on_little, 8.0);
    EXPECT_GT(on_little, 3.0);
    EXPECT_EQ(sensible_px_per_mm(2000.0, 1000.0, kCommon), 3.0);
    EXPECT_EQ(sensible_px_per_mm(297.0, 210.0, {8.0, 0}), 4.0);
}

TEST(CanvasChoices, ScreensHaveTheirPixels) {
    const auto sizes = canvas_sizes();
    const auto screen = std::find_if(sizes.begin(), sizes.end(), [](const CanvasSize& size) {
        return size.name == QStringLiteral("Screen, QHD");
    });
    ASSERT_NE(screen, sizes.end());
    const grid::Shape shape = document::canvas_shape(canvas_of(*screen, true, "linen", kCommon));
    EXPECT_EQ(shape.width, 1440);
    EXPECT_EQ(shape.height, 2560);
}

}  // namespace
}  // namespace pastoso::start
