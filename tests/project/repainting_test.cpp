// Paintings painted again from their strokes, on other cells.
#include "project/repainting.hpp"

#include "core/error.hpp"
#include "core/message_text.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"

#include <cstdint>

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using namespace document;
using testing::HasSubstr;

constexpr std::size_t kPlenty_bytes = std::size_t{1} << 32;

/// A stroke of red; the pen is down until the end unless it is lifted.
Recording one_stroke(double px_per_mm, bool lifted) {
    CanvasSettings canvas;
    canvas.width_mm = 30.0;
    canvas.height_mm = 20.0;
    canvas.px_per_mm = px_per_mm;
    Recording strokes{canvas, {}, 40};
    LoadPaint dip;
    dip.paint.ingredients = {{"PR108", 1.0}};
    strokes.events = {
        {0, UseMedium{"heavy-body oil"}}, {0, TakeBrush{"Flat bristle 20", 6.0, 1}}, {0, dip}};
    for (int i = 0; i <= 20; ++i) {
        brush::PenSample sample;
        sample.time_s = i * kTick_s;
        sample.x_mm = 5.0 + i;
        sample.y_mm = 10.0;
        strokes.events.push_back({i, i == 0 ? Action{PenDown{sample}} : Action{PenMove{sample}}});
    }
    if (lifted) strokes.events.push_back({21, PenUp{}});
    return strokes;
}

struct RepaintingTest : testing::Test {
    core::ThreadPool pool{2};

    std::optional<Project> repainted(const Recording& strokes, int most_ticks = 1000) {
        int ticks = 0;
        return repaint(strokes, "a", pool, [&](double) { return ticks++ < most_ticks; });
    }
    double volume_mm3(const Project& painted) {
        const Painting painting(painted.painting, pool);
        return film::volume_mm3(film::totals(painting.film()).thickness, painting.film().cell_mm);
    }
    std::string refusal(const Recording& strokes, std::size_t available_bytes) {
        try {
            repainting_terms(strokes, "a", available_bytes);
        } catch (const core::InputError& error) {
            return error.what();
        }
        return {};
    }
};

TEST_F(RepaintingTest, LaysAsMuchPaintOnFinerCells) {
    const double coarse_mm3 = volume_mm3(repainted(one_stroke(4.0, true)).value());
    const double fine_mm3 = volume_mm3(repainted(one_stroke(9.0, true)).value());
    EXPECT_GT(coarse_mm3, 1.0);
    // What bristles miss of a weave of half a millimetre is told more finely.
    EXPECT_NEAR(fine_mm3 / coarse_mm3, 1.0, 0.1);
}

TEST_F(RepaintingTest, APenThatIsStillDownIsLifted) {
    const Project painted = repainted(one_stroke(3.0, false)).value();
    EXPECT_TRUE(std::holds_alternative<PenUp>(painted.strokes.events.back().action));
    EXPECT_EQ(painted.strokes.arithmetic, kArithmetic);
    const Project again = repainted(painted.strokes).value();
    EXPECT_EQ(state_hash(again.painting), state_hash(painted.painting));
    EXPECT_EQ(again.strokes, painted.strokes);
}

TEST_F(RepaintingTest, StopsWhenItIsTold) {
    EXPECT_FALSE(repainted(one_stroke(3.0, true), 5));
}

TEST_F(RepaintingTest, ShowsThePaintingTickByTick) {
    std::vector<std::int64_t> ticks;
    repaint(
        one_stroke(3.0, true), "a", pool, [](double) { return true; },
        [&](const Painting& painting) { ticks.push_back(painting.tick()); });
    ASSERT_GE(ticks.size(), 40U);
    EXPECT_EQ(ticks.front(), 1);
    EXPECT_EQ(ticks.back(), 40);
}

TEST_F(RepaintingTest, TermsAreToldBefore) {
    Recording strokes = one_stroke(10.0, true);
    const RepaintingTerms terms = repainting_terms(strokes, "a", kPlenty_bytes);
    EXPECT_EQ(terms.cells, (grid::Shape{300, 200}));
    EXPECT_GT(terms.memory_bytes, 300U * 200U * 64U);
    EXPECT_TRUE(terms.notes.empty());
    strokes.arithmetic = 1;
    strokes.canvas.support = "image";
    EXPECT_THAT(core::texts_of(repainting_terms(strokes, "a", kPlenty_bytes).notes),
                testing::ElementsAre(HasSubstr("its strokes were painted with an earlier version"),
                                     HasSubstr("its support is a picture")));
}

TEST_F(RepaintingTest, TermsCountEverySizeThatTheCanvasComesToHave) {
    Recording strokes = one_stroke(10.0, true);
    const auto cells_after = [&](std::initializer_list<Action> actions) {
        Recording longer = strokes;
        for (const Action& action : actions)
            longer.events.push_back({40, action});
        return repainting_terms(longer, "a", kPlenty_bytes);
    };
    const ScaleCanvas doubled{1.0, 1.0, 2.0};
    EXPECT_EQ(cells_after({doubled}).cells, (grid::Shape{600, 400}));
    EXPECT_EQ(cells_after({TurnCanvas{{false, 1}}, ResizeCanvas{0, 0, 20, 50}}).cells,
              (grid::Shape{200, 500}));
    EXPECT_EQ(cells_after({RotateCanvas{90.0}}).cells, (grid::Shape{200, 300}));
    EXPECT_EQ(cells_after({RotateCanvas{30.0, true}}).cells, (grid::Shape{300, 200}));
    const RepaintingTerms undone = cells_after({doubled, Undo{}});
    EXPECT_EQ(undone.cells, (grid::Shape{300, 200}));
    EXPECT_EQ(undone.memory_bytes, cells_after({doubled}).memory_bytes) << "meanwhile";
    EXPECT_EQ(cells_after({doubled, Undo{}, doubled, Undo{}, doubled}).cells, (grid::Shape{600, 400}));
    EXPECT_EQ(cells_after({doubled, Undo{}, Redo{}}).cells, (grid::Shape{600, 400}));
}

TEST_F(RepaintingTest, WhatCannotBeIsRefused) {
    EXPECT_THAT(refusal({}, kPlenty_bytes), HasSubstr("a: holds no strokes"));
    EXPECT_THAT(refusal(one_stroke(10.0, true), 1000), HasSubstr("a: A canvas of 30 x 20 mm"));
    EXPECT_THAT(refusal(one_stroke(100.0, true), kPlenty_bytes), testing::StartsWith("a: "));
}

}  // namespace
}  // namespace pastoso::project
