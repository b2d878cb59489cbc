// Selections by colour and by paint, and selections made wider and narrower.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/played.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

CanvasSettings canvas_of(double px_per_mm) {
    CanvasSettings canvas = small_canvas();
    canvas.support = "panel";
    canvas.px_per_mm = px_per_mm;
    return canvas;
}

SelectArea box(double x0_mm, double y0_mm, double x1_mm, double y1_mm,
               Combination how = Combination::Replace) {
    return {{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}, how};
}

/// A panel of 40 x 30 mm with two blue fields and a red one between them.
class SelectionChanges : public testing::Test {
  protected:
    static void paint_fields(Painting& painting) {
        painting.apply(UseMedium{"soft-body acrylic"});
        fill(painting, box(4, 4, 12, 20), "PB29");
        fill(painting, box(12, 4, 20, 20), "PR108");
        fill(painting, box(26, 4, 34, 20), "PB29");
    }
    static void fill(Painting& painting, const SelectArea& area, const char* pigment) {
        painting.apply(area);
        painting.apply(FillWithPaint{.paint = {{{pigment, 1.0}}}});
        painting.apply(SelectAll{});
    }
    void SetUp() override { paint_fields(painting); }

    static Selection selection_of(const Painting& of) { return of.state().value.selection; }
    /// 0 where none is selected.
    static double selected_mm2(const Painting& of) {
        const Selection selection = selection_of(of);
        const double cell_mm = of.film().cell_mm;
        return selection ? static_cast<double>(grid::chosen_cells(*selection)) * cell_mm * cell_mm : 0.0;
    }
    bool selected(double x_mm, double y_mm) const {
        return selection_of(painting)->at(static_cast<int>(x_mm / 0.25),
                                          static_cast<int>(y_mm / 0.25)) != 0;
    }

    core::ThreadPool pool{2};
    Painting painting{canvas_of(4.0), pool};
};

TEST_F(SelectionChanges, TheWandTakesWhatHangsTogether) {
    painting.apply(SelectSimilarColour{8, 10});
    EXPECT_EQ(selected_mm2(painting), 8.0 * 16.0);
    EXPECT_TRUE(selected(5, 5));
    EXPECT_FALSE(selected(15, 10) || selected(30, 10) || selected(2, 10));
    painting.apply(SelectSimilarColour{30, 10, 10.0, true, Combination::Add});
    EXPECT_EQ(selected_mm2(painting), 2 * 8.0 * 16.0);
}

TEST_F(SelectionChanges, SimilarColourIsTakenEverywhere) {
    painting.apply(SelectSimilarColour{.x_mm = 8, .y_mm = 10, .connected = false});
    EXPECT_EQ(selected_mm2(painting), 2 * 8.0 * 16.0);
    painting.apply(Undo{});
    EXPECT_EQ(selection_of(painting), nullptr);
    painting.apply(SelectSimilarColour{.x_mm = 1, .y_mm = 1, .connected = false});
    EXPECT_EQ(selected_mm2(painting), 40.0 * 30.0 - 3 * 8.0 * 16.0) << "the bare ground";
}

TEST_F(SelectionChanges, ALargerDifferenceTakesMore) {
    painting.apply(SelectSimilarColour{8, 10, kMostDifference});
    EXPECT_EQ(selected_mm2(painting), 40.0 * 30.0);
    painting.apply(SelectSimilarColour{8, 10, 0.0});
    EXPECT_EQ(selected_mm2(painting), 8.0 * 16.0) << "an even film is of one colour";
}

TEST_F(SelectionChanges, APlaceBesideTheCanvasIsItsNearestCell) {
    painting.apply(SelectSimilarColour{-5, 1000});
    EXPECT_FALSE(selected(8, 10));
    EXPECT_TRUE(selected(0.1, 29.9));
}

TEST_F(SelectionChanges, ColoursAreThoseOfAllThatIsVisible) {
    painting.apply(AddLayer{"Glaze"});
    painting.apply(SelectSimilarColour{8, 10});
    EXPECT_EQ(selected_mm2(painting), 8.0 * 16.0) << "a bare layer hides nothing";
    painting.apply(box(4, 4, 34, 20));
    painting.apply(FillWithPaint{.paint = {{{"PR108", 1.0}}}, .thickness_mm = 1.0});
    painting.apply(SelectSimilarColour{8, 10});
    EXPECT_EQ(selected_mm2(painting), 30.0 * 16.0) << "the red hides the fields";
    painting.apply(SetLayer{2, {.name = "Glaze", .visible = false}});
    painting.apply(SelectSimilarColour{8, 10});
    EXPECT_EQ(selected_mm2(painting), 8.0 * 16.0);
}

TEST_F(SelectionChanges, AnyNumberOfThreadsFindsTheSame) {
    core::ThreadPool alone(1);
    Painting other(canvas_of(4.0), alone);
    paint_fields(other);
    for (Painting* one : {&painting, &other})
        one->apply(SelectSimilarColour{15, 10, 25.0});
    const grid::Mask& found = *selection_of(painting);
    EXPECT_EQ(grid::chosen_cells(found), grid::chosen_cells(*selection_of(other)));
    EXPECT_EQ(grid::chosen_cells(grid::combined(found, *selection_of(other), Combination::Subtract)), 0);
}

TEST_F(SelectionChanges, ARecordingFindsTheSameColourAtAnyResolution) {
    Recording recording{.canvas = canvas_of(4.0), .events = {{0, UseMedium{"soft-body acrylic"}}}};
    const auto record_field = [&](const SelectArea& area, const char* pigment) {
        recording.events.push_back({0, area});
        recording.events.push_back({0, FillWithPaint{.paint = {{{pigment, 1.0}}}}});
    };
    record_field(box(4, 4, 12, 20), "PB29");
    record_field(box(12, 4, 20, 20), "PR108");
    record_field(box(26, 4, 34, 20), "PB29");
    recording.events.push_back({0, SelectSimilarColour{8, 10}});
    for (const int px_per_mm : {3, 4, 7}) {
        const int p = px_per_mm;
        recording.canvas.px_per_mm = px_per_mm;
        const auto again = played(recording, pool);
        EXPECT_EQ(grid::chosen_area(*selection_of(*again)), (grid::Rect{4 * p, 4 * p, 12 * p, 20 * p}));
        EXPECT_NEAR(selected_mm2(*again), 8.0 * 16.0, 1e-9) << "all of the field, at " << p;
        again->apply(SelectSimilarColour{.x_mm = 8, .y_mm = 10, .connected = false});
        EXPECT_EQ(grid::chosen_area(*selection_of(*again)), (grid::Rect{4 * p, 4 * p, 34 * p, 20 * p}));
        EXPECT_NEAR(selected_mm2(*again), 2 * 8.0 * 16.0, 1e-9) << "both blue ones, at " << p;
    }
}

TEST_F(SelectionChanges, PaintOfTheActiveLayerIsFoundWetAndDry) {
    painting.apply(SelectPaint{});
    EXPECT_EQ(selected_mm2(painting), 3 * 8.0 * 16.0);
    painting.apply(SelectAll{});
    painting.apply(DryNow{});
    painting.apply(SelectPaint{});
    EXPECT_EQ(selected_mm2(painting), 3 * 8.0 * 16.0);
    painting.apply(SelectAll{});
    painting.apply(AddLayer{"Second"});
    painting.apply(SelectPaint{});
    EXPECT_EQ(selection_of(painting), nullptr) << "the layer below does not count";
    fill(painting, box(0, 0, 10, 10), "PW6");
    painting.apply(SelectPaint{});
    EXPECT_EQ(selected_mm2(painting), 100.0);
    painting.apply(box(0, 0, 40, 5));
    painting.apply(SelectPaint{Combination::Intersect});
    EXPECT_EQ(selected_mm2(painting), 50.0);
}

TEST_F(SelectionChanges, MarginsAreMillimetres) {
    painting.apply(box(10, 10, 20, 20));
    painting.apply(GrowSelection{2.0});
    EXPECT_EQ(grid::chosen_area(*selection_of(painting)), (grid::Rect{32, 32, 88, 88}));
    painting.apply(Undo{});
    painting.apply(ShrinkSelection{2.0});
    EXPECT_EQ(selected_mm2(painting), 36.0);
    painting.apply(Undo{});
    painting.apply(BorderSelection{2.0});
    EXPECT_TRUE(selected(9.5, 15) && selected(10.5, 15));
    EXPECT_FALSE(selected(8.5, 15) || selected(11.5, 15) || selected(15, 15));
    painting.apply(Undo{});
    EXPECT_TRUE(selected(15, 15));
    painting.apply(Redo{});
    EXPECT_FALSE(selected(15, 15));
}

TEST_F(SelectionChanges, MarginsAreTheSameAtAnyResolution) {
    for (const double px_per_mm : {2.0, 3.0, 7.0}) {
        Painting other(canvas_of(px_per_mm), pool);
        other.apply(box(10, 10, 20, 20));
        other.apply(GrowSelection{3.0});
        // A square with rounded corners; its outline is uncertain by half a cell.
        EXPECT_NEAR(selected_mm2(other), 100.0 + 4 * 30.0 + 3.1416 * 9.0, 59.0 * 0.5 / px_per_mm);
        other.apply(ShrinkSelection{3.0});
        EXPECT_EQ(selected_mm2(other), 100.0) << "what has no narrow bays comes back as it was";
    }
}

TEST_F(SelectionChanges, NothingSelectedHasNoMargins) {
    const std::size_t steps = painting.undo_steps().size();
    painting.apply(GrowSelection{2.0});
    painting.apply(ShrinkSelection{2.0});
    painting.apply(BorderSelection{2.0});
    EXPECT_EQ(painting.undo_steps().size(), steps);
    painting.apply(box(10, 10, 12, 12));
    painting.apply(ShrinkSelection{5.0});
    EXPECT_EQ(selection_of(painting), nullptr) << "a selection of nothing is none";
}

TEST_F(SelectionChanges, ValuesOutOfRangeAreRefused) {
    const auto error = [&](const Action& action) { return error_of([&] { painting.apply(action); }); };
    EXPECT_EQ(error(GrowSelection{0.0}),
              "the width of the margin in mm is 0, but must lie between 0.01 and 1000.");
    EXPECT_THAT(error(ShrinkSelection{2000.0}), HasSubstr("width of the margin"));
    EXPECT_THAT(error(BorderSelection{-1.0}), HasSubstr("width of the margin"));
    EXPECT_THAT(error(SelectSimilarColour{8, 10, 101.0}), HasSubstr("difference of the colour"));
    EXPECT_THAT(error(SelectSimilarColour{1e9, 10}), HasSubstr("x of the colour's place"));
}

}  // namespace
}  // namespace pastoso::document
