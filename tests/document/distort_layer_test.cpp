// Layers and selections that are drawn by their corners.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/played.hpp"
#include "document/scenes.hpp"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

constexpr double kRounding = 1e-9;

/// From (4, 4) to (36, 26), narrower at the top.
constexpr layers::Distortion kFarAbove{{4, 4}, 32, 22, {12, 6}, {28, 5}, {37, 27}, {3, 25}};

class LayerDistorting : public testing::Test {
  protected:
    /// Dry acrylic, wet oil and wet thinned acrylic, on two layers.
    void SetUp() override {
        paint_dry_wave(painting);
        painting.apply(load_of("PY35"));
        paint_wave(painting, 1.0, 22.0);
        painting.apply(CleanBrush{});
        painting.apply(UseMedium{"heavy-body oil"});
        painting.apply(load_of("PR108"));
        paint_wave(painting, 2.0, 14.0);
        painting.apply(AddLayer{"Above"});
        paint_wave(painting, 3.0, 18.0);
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    double on_canvas_mm3() const {
        return painting.account().canvas.volume_mm3 + painting.account().dried.volume_mm3;
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

/// Of the wet paint.
grid::Point middle_mm(const film::FilmState& film) {
    double sum = 0.0;
    grid::Point sums;
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            const double thickness = film.thickness.at(x, y);
            sum += thickness;
            sums.x += thickness * (x + 0.5);
            sums.y += thickness * (y + 0.5);
        }
    return {film.cell_mm * sums.x / sum, film.cell_mm * sums.y / sum};
}

TEST_F(LayerDistorting, WhatThereIsLessOfIsBooked) {
    const double before_mm3 = on_canvas_mm3();
    const double wiped_mm3 = painting.account().ledger.volume_mm3;
    painting.apply(DistortLayer{1, kFarAbove});
    EXPECT_LT(on_canvas_mm3(), before_mm3);
    EXPECT_NEAR(painting.account().ledger.volume_mm3 - wiped_mm3, before_mm3 - on_canvas_mm3(), 1e-6);
    expect_balance();
}

TEST_F(LayerDistorting, WhatThereIsMoreOfComesOutOfTheTubes) {
    const double before_mm3 = on_canvas_mm3(), taken_mm3 = painting.account().taken.volume_mm3;
    painting.apply(DistortLayer{2, {{14, 14}, 10, 8, {8, 8}, {32, 10}, {36, 26}, {4, 24}}});
    EXPECT_GT(on_canvas_mm3(), before_mm3);
    EXPECT_GT(painting.account().taken.volume_mm3, taken_mm3);
    expect_balance();
}

TEST_F(LayerDistorting, UndoGivesEveryBitBack) {
    const std::uint64_t before = painting.state_hash();
    painting.apply(DistortLayer{1, kFarAbove});
    const std::uint64_t after = painting.state_hash();
    EXPECT_NE(after, before);
    EXPECT_EQ(painting.undo_steps().back().step.name, "Transform");
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
    expect_balance();
}

TEST_F(LayerDistorting, CornersThatMoveTogetherAreATransform) {
    core::ThreadPool other_pool(1);
    Painting other(painting.state(), other_pool);
    painting.apply(DistortLayer{1, {{4, 4}, 32, 22, {7, 5}, {39, 5}, {39, 27}, {7, 27}}});
    other.apply(TransformLayer{1, {.move_x_mm = 3.0, .move_y_mm = 1.0}});
    EXPECT_EQ(painting.state_hash(), other.state_hash());
}

TEST_F(LayerDistorting, OnlyWhatIsSelectedIsDrawnAndTheSelectionComesAlong) {
    painting.apply(SelectArea{{{0, 0}, {20, 0}, {20, 30}, {0, 30}}});
    const film::FilmState before = painting.film();
    painting.apply(DistortLayer{2, {{0, 0}, 20, 30, {0, 0}, {20, 5}, {20, 20}, {0, 30}}});
    for (int y = 0; y < 90; ++y) {
        // Cells come from parallelograms, which reach over a line that stays by some hundredths.
        EXPECT_NEAR(painting.film().thickness.at(60, y), before.thickness.at(60, y),
                    2e-3 / film::kThicknessQuantum_mm);
        for (int x = 61; x < 120; ++x)
            ASSERT_EQ(painting.film().thickness.at(x, y), before.thickness.at(x, y)) << x << ", " << y;
    }
    const grid::Mask& selected = *painting.state().value.selection;
    EXPECT_EQ(grid::chosen_area(selected).width(), 60);
    // Half of the sides' lengths together, times the distance between them.
    EXPECT_NEAR(static_cast<double>(grid::chosen_cells(selected)), 0.5 * (90 + 45) * 60, 30.0);
    expect_balance();
}

TEST_F(LayerDistorting, CornersFarBeyondTheCanvasAreNone) {
    painting.apply(DistortLayer{1, {{4, 4}, 32, 22, {-300, -200}, {42, 2}, {300, 220}, {-2, 31}}});
    expect_balance();
    painting.apply(DistortLayer{1, {{4, 4}, 32, 22, {1004, 4}, {1036, 5}, {1036, 26}, {1004, 26}}});
    expect_balance();
    EXPECT_EQ(painting.account().dried.volume_mm3, 0.0);
}

TEST_F(LayerDistorting, WhatIsNoAreaIsRefused) {
    const std::uint64_t before = painting.state_hash();
    const std::size_t steps = painting.undo_steps().size();
    const auto refused = [&](layers::Place lower_right) {
        layers::Distortion told = kFarAbove;
        told.lower_right = lower_right;
        return error_of([&] { painting.apply(DistortLayer{1, told}); });
    };
    EXPECT_THAT(refused({14, 8}), HasSubstr("bends outwards at each of them"));
    EXPECT_THAT(refused({12, 7}), HasSubstr("bends outwards at each of them"));
    EXPECT_THAT(refused({28, 5.1}),
                HasSubstr("length of a side of the distortion, times what it was, is"));
    EXPECT_THAT(error_of([&] {
                    layers::Distortion told = kFarAbove;
                    told.width_mm = 0.0;
                    painting.apply(DistortLayer{1, told});
                }),
                HasSubstr("x of the size of what is distorted"));
    EXPECT_THAT(error_of([&] { painting.apply(DistortLayer{7, kFarAbove}); }), HasSubstr("7"));
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(painting.undo_steps().size(), steps);
    painting.apply(SetLayer{1, {.name = "Sky", .locked = true}});
    EXPECT_THAT(error_of([&] {
                    painting.apply(DistortLayer{1, kFarAbove});
                }),
                HasSubstr("\"Sky\" is locked"));
}

TEST_F(LayerDistorting, ARecordingReplaysToTheSameBits) {
    Recording recording = crossing_session();
    recording.events.push_back({50, DistortLayer{1, kFarAbove}});
    core::ThreadPool one(1), three(3);
    EXPECT_EQ(played(recording, one)->state_hash(), played(recording, three)->state_hash());
}

TEST_F(LayerDistorting, AtAnotherResolutionItDistortsAlike) {
    Recording recording = crossing_session();
    recording.events.push_back({recording.end_tick, DistortLayer{1, kFarAbove}});
    const auto coarse = played(recording, pool);
    recording.canvas.px_per_mm = 6.0;
    const auto fine = played(recording, pool);
    const double coarse_mm3 = coarse->account().canvas.volume_mm3;
    EXPECT_NEAR(fine->account().canvas.volume_mm3, coarse_mm3, 0.1 * coarse_mm3);
    const grid::Point one = middle_mm(coarse->film()), same = middle_mm(fine->film());
    EXPECT_NEAR(same.x, one.x, 0.5);
    EXPECT_NEAR(same.y, one.y, 0.5);
}

}  // namespace
}  // namespace pastoso::document
