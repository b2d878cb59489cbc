// Selections with soft edges, and what tools, fills and cuts make of them.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr double kRounding = 1e-9;
constexpr double kFilm_mm = 0.4;

CanvasSettings panel(double px_per_mm) {
    CanvasSettings canvas = small_canvas();
    canvas.support = "panel";
    canvas.px_per_mm = px_per_mm;
    return canvas;
}

SelectArea box(double x0_mm, double y0_mm, double x1_mm, double y1_mm,
               Combination how = Combination::Replace) {
    return {{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}, how};
}

FillWithPaint wash(const char* pigment) {
    return {.paint = {{{pigment, 1.0}}}, .thickness_mm = kFilm_mm};
}

Selection selection_of(const Painting& painting) {
    return painting.state().value.selection;
}

/// Wet quanta between two columns, in mm.
std::int64_t wet_between(const Painting& painting, double from_mm, double to_mm) {
    const film::FilmState& film = painting.film();
    std::int64_t sum = 0;
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            const double middle_mm = (x + 0.5) * film.cell_mm;
            if (middle_mm > from_mm && middle_mm < to_mm) sum += film.thickness.at(x, y);
        }
    return sum;
}

class FeatherTest : public testing::Test {
  protected:
    void SetUp() override { painting.apply(UseMedium{"soft-body acrylic"}); }

    static void expect_balance(const Painting& of) {
        EXPECT_LT(of.account().volume_error_rel(), kRounding);
        EXPECT_LT(of.account().pigment_error_rel(), kRounding);
    }
    void select_softly() {
        painting.apply(box(10, 8, 30, 22));
        painting.apply(FeatherSelection{4.0});
        mask = *selection_of(painting);
        ASSERT_TRUE(grid::is_soft(mask));
    }
    /// Calls `check(x, y, share)` for every cell of the canvas.
    template <class Check>
    void for_cells(const Check& check) const {
        for (int y = 0; y < mask.shape().height; ++y)
            for (int x = 0; x < mask.shape().width; ++x)
                check(x, y, mask.at(x, y));
    }
    std::int32_t wet_at(int x, int y) const { return painting.film().thickness.at(x, y); }

    static constexpr std::int32_t kWashQuanta =
        static_cast<std::int32_t>(kFilm_mm / film::kThicknessQuantum_mm + 0.5);
    core::ThreadPool pool{2};
    Painting painting{panel(4.0), pool};
    grid::Mask mask;
};

TEST_F(FeatherTest, TheEdgeFadesOverTheRadiusOnEitherSide) {
    select_softly();
    EXPECT_EQ(mask.at(80, 60), grid::kWhole);
    EXPECT_EQ(mask.at(4 * 15, 60), grid::kWhole) << "5 mm within";
    EXPECT_EQ(mask.at(4 * 5 - 1, 60), 0) << "5 mm beyond";
    EXPECT_TRUE(grid::is_chosen(mask.at(40, 60)));
    EXPECT_FALSE(grid::is_chosen(mask.at(39, 60)));
    EXPECT_GT(mask.at(39, 60), 110);
}

TEST_F(FeatherTest, IsUndoneAndRedone) {
    painting.apply(box(10, 8, 30, 22));
    const std::size_t steps = painting.undo_steps().size();
    painting.apply(FeatherSelection{4.0});
    const grid::Mask soft = *selection_of(painting);
    EXPECT_EQ(painting.undo_steps().size(), steps + 1);
    painting.apply(Undo{});
    EXPECT_FALSE(grid::is_soft(*selection_of(painting)));
    painting.apply(Redo{});
    mask = soft;
    for_cells([&](int x, int y, std::uint8_t share) {
        ASSERT_EQ(selection_of(painting)->at(x, y), share) << x << ", " << y;
    });
}

TEST_F(FeatherTest, NothingSelectedHasNoEdge) {
    const std::size_t steps = painting.undo_steps().size();
    painting.apply(FeatherSelection{2.0});
    EXPECT_EQ(painting.undo_steps().size(), steps);
    EXPECT_EQ(selection_of(painting), nullptr);
    EXPECT_EQ(error_of([&] { painting.apply(FeatherSelection{0.0}); }),
              "the radius of the feather in mm is 0, but must lie between 0.01 and 1000.");
}

TEST_F(FeatherTest, AFillIsAsThickAsTheShare) {
    select_softly();
    painting.apply(wash("PB29"));
    for_cells([&](int x, int y, std::uint8_t share) {
        ASSERT_EQ(wet_at(x, y), grid::share_of(kWashQuanta, share)) << x << ", " << y;
    });
    expect_balance(painting);
    painting.apply(Undo{});
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
}

TEST_F(FeatherTest, AFillHoldsTheSameAtAnyResolution) {
    for (const double px_per_mm : {2.0, 3.0, 7.0}) {
        Painting other(panel(px_per_mm), pool);
        other.apply(UseMedium{"soft-body acrylic"});
        other.apply(box(10, 8, 30, 22));
        other.apply(FeatherSelection{4.0});
        other.apply(wash("PB29"));
        // A soft edge holds as much beyond the outline as is missing within. Shares are rounded.
        EXPECT_NEAR(other.account().canvas.volume_mm3, 20.0 * 14.0 * kFilm_mm, 0.5) << px_per_mm;
    }
}

TEST_F(FeatherTest, ClearingTakesTheShare) {
    painting.apply(wash("PB29"));
    select_softly();
    const std::uint64_t before = painting.state_hash();
    painting.apply(ClearLayer{1});
    for_cells([&](int x, int y, std::uint8_t share) {
        ASSERT_EQ(wet_at(x, y), kWashQuanta - grid::share_of(kWashQuanta, share)) << x << ", " << y;
    });
    expect_balance(painting);
    const std::uint64_t after = painting.state_hash();
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
}

TEST_F(FeatherTest, ClearingDryPaintTakesTheShareOfItsRelief) {
    painting.apply(wash("PB29"));
    painting.apply(DryNow{});
    const double dried_mm3 = painting.account().dried.volume_mm3;
    const film::FilmState before = painting.film();
    const film::SupportHeights bare = painting.state().value.bare->support_mm;
    select_softly();
    painting.apply(ClearLayer{1});
    // What can be dissolved and what is fixed are rounded to steps of the support apart.
    for_cells([&](int x, int y, std::uint8_t share) {
        const double whole_mm = before.support_mm.at(x, y) - bare.at(x, y);
        ASSERT_NEAR(painting.film().support_mm.at(x, y) - bare.at(x, y),
                    whole_mm * (1.0 - share / 255.0), 2.0 * film::kSupportQuantum_mm);
    });
    EXPECT_LT(painting.account().dried.volume_mm3, 0.9 * dried_mm3);
    expect_balance(painting);
}

TEST_F(FeatherTest, WhatIsCutAndPastedIsTogetherWhatThereWas) {
    painting.apply(wash("PB29"));
    select_softly();
    const double whole_mm3 = painting.account().canvas.volume_mm3;
    painting.apply(CopyPaint{1});
    painting.apply(ClearLayer{1});
    painting.apply(SelectAll{});
    painting.apply(PastePaint{"Piece"});
    for_cells([&](int x, int y, std::uint8_t share) {
        ASSERT_EQ(wet_at(x, y), grid::share_of(kWashQuanta, share)) << x << ", " << y;
    });
    EXPECT_NEAR(painting.account().canvas.volume_mm3, whole_mm3, kRounding * whole_mm3);
    expect_balance(painting);
}

TEST_F(FeatherTest, MovingTakesTheShareAlong) {
    painting.apply(wash("PB29"));
    select_softly();
    painting.apply(TransformLayer{1, {.move_x_mm = 5.0}});
    expect_balance(painting);
    EXPECT_EQ(selection_of(painting)->at(80 + 20, 60), grid::kWhole);
    EXPECT_EQ(selection_of(painting)->at(39 + 20, 60), mask.at(39, 60));
}

TEST_F(FeatherTest, AStrokeFadesOut) {
    Painting unlimited(panel(4.0), pool);
    for (Painting* one : {&painting, &unlimited}) {
        one->apply(UseMedium{"soft-body acrylic"});
        one->apply(TakeBrush{"flat", 8, 1});
        one->apply(load_of("PB29"));
    }
    painting.apply(box(0, 0, 20, 30));
    painting.apply(FeatherSelection{5.0});
    for (Painting* one : {&painting, &unlimited})
        paint_wave(*one, 0.0, 15.0);
    const auto share_between = [&](double from_mm, double to_mm) {
        return static_cast<double>(wet_between(painting, from_mm, to_mm)) /
               static_cast<double>(wet_between(unlimited, from_mm, to_mm));
    };
    EXPECT_GT(share_between(7.0, 11.0), 0.95);
    EXPECT_LT(share_between(21.5, 23.0), 0.9);
    EXPECT_GT(share_between(21.5, 23.0), 0.0);
    EXPECT_LT(share_between(23.0, 24.0), share_between(21.5, 23.0));
    EXPECT_EQ(wet_between(painting, 25.5, 40.0), 0);
    expect_balance(painting);
}

TEST_F(FeatherTest, AnEdgeFinerThanCellsIsHardToTheBit) {
    Painting hard(panel(4.0), pool);
    for (Painting* one : {&painting, &hard}) {
        one->apply(UseMedium{"soft-body acrylic"});
        one->apply(TakeBrush{"flat", 8, 1});
        one->apply(load_of("PB29"));
        one->apply(box(10, 8, 30, 22));
    }
    painting.apply(FeatherSelection{0.1});
    for (Painting* one : {&painting, &hard}) {
        paint_wave(*one, 0.0, 15.0);
        for (int tick = 0; tick < 10; ++tick)
            one->advance_tick();
        one->apply(ClearLayer{1});
    }
    EXPECT_EQ(painting.state_hash(), hard.state_hash());
}

TEST_F(FeatherTest, AnyNumberOfThreadsPaintsTheSame) {
    core::ThreadPool alone(1);
    Painting other(panel(4.0), alone);
    for (Painting* one : {&painting, &other}) {
        one->apply(UseMedium{"soft-body acrylic"});
        one->apply(box(10, 8, 30, 22));
        one->apply(FeatherSelection{4.0});
        one->apply(TakeBrush{"flat", 8, 1});
        one->apply(load_of("PB29"));
        paint_wave(*one, 0.0, 15.0);
    }
    EXPECT_EQ(painting.state_hash(), other.state_hash());
}

TEST_F(FeatherTest, MaskingAndDryingTakeWhatIsSelectedByHalf) {
    painting.apply(wash("PB29"));
    select_softly();
    painting.apply(DryNow{});
    for_cells([&](int x, int y, std::uint8_t share) {
        ASSERT_EQ(wet_at(x, y) == 0, grid::is_chosen(share)) << x << ", " << y;
    });
    painting.apply(MaskSelection{});
    const grid::Mask masked = *painting.state().value.masking.cells;
    for_cells([&](int x, int y, std::uint8_t share) {
        ASSERT_EQ(masked.at(x, y), grid::is_chosen(share) ? grid::kWhole : 0) << x << ", " << y;
    });
}

TEST_F(FeatherTest, InvertedItIsTheRest) {
    select_softly();
    painting.apply(InvertSelection{});
    for_cells([&](int x, int y, std::uint8_t share) {
        ASSERT_EQ(selection_of(painting)->at(x, y), grid::kWhole - share) << x << ", " << y;
    });
}

}  // namespace
}  // namespace pastoso::document
