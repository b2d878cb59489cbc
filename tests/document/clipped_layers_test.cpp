// Layers that are clipped to the layer below: what does not lie over its paint is hidden, and kept.
#include "document/error_of.hpp"
#include "document/layered_canvas.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/player.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

using testing::ElementsAre;

constexpr double kRounding = 1e-9;
constexpr double kFilm_mm = 0.25;  // a power of two: as thick in whole quanta

SelectArea box(double x0_mm, double y0_mm, double x1_mm, double y1_mm) {
    return {{{x0_mm, y0_mm}, {x1_mm, y0_mm}, {x1_mm, y1_mm}, {x0_mm, y1_mm}}};
}

/// What the lower layer has, what the upper one has, and what both have; 3 cells to a millimetre.
const SelectArea kShape = box(10, 10, 20, 20), kOver = box(5, 5, 15, 25), kBoth = box(10, 10, 15, 20);
constexpr int kHiddenCells = 3 * 3 * (10 * 20 - 5 * 10);

constexpr int kShownX = 36, kHiddenX = 20, kY = 45;  // cells of the upper layer

SetLayer clipped(LayerId layer, const char* name = "Upper") {
    return {layer, {.name = name, .clipped = true}};
}

void fill(Painting& painting, const char* pigment, const SelectArea& area) {
    painting.apply(area);
    painting.apply(FillWithPaint{.paint = {{{pigment, 1.0}}}, .thickness_mm = kFilm_mm});
    painting.apply(SelectAll{});
}

/// A shape, and above it on a layer of its own what reaches beyond it.
void lay_both(Painting& painting, const SelectArea& over = kOver) {
    fill(painting, "PB29", kShape);
    painting.apply(AddLayer{"Upper"});
    fill(painting, "PY35", over);
}

bool same_look(const film::FilmState& a, const film::FilmState& b, int x, int y) {
    return a.thickness.at(x, y) == b.thickness.at(x, y) && a.paint.at(x, y) == b.paint.at(x, y) &&
           a.support_mm.at(x, y) == b.support_mm.at(x, y) &&
           a.strata.optics.at(x, y) == b.strata.optics.at(x, y);
}

void expect_same_look(const film::FilmState& a, const film::FilmState& b) {
    for (int y = 0; y < a.shape.height; ++y)
        for (int x = 0; x < a.shape.width; ++x)
            ASSERT_TRUE(same_look(a, b, x, y)) << x << ", " << y;
}

class ClippedLayers : public testing::Test {
  protected:
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    static std::uint64_t looks(const Painting& of) {
        film::FilmState seen = of.snapshot().film;
        seen.velocity_x = seen.velocity_y = grid::TiledField<float>(seen.shape);
        seen.consistencies = {};  // depends on which layer is active
        return film::state_hash(seen);
    }
    std::uint64_t looks() const { return looks(painting); }
    /// What the view, which remembers, shows is what a new one does.
    void expect_whole_view(const char* when) const {
        EXPECT_EQ(looks(), looks(Painting(painting.state(), pool))) << when;
    }
    std::string error(const Action& action) {
        return error_of([&] { painting.apply(action); });
    }
    std::vector<LayerId> order() const {
        std::vector<LayerId> ids;
        for (const Layer& layer : painting.layers().layers)
            ids.push_back(layer.id);
        return ids;
    }

    mutable core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

TEST_F(ClippedLayers, ShowOnlyOverPaintOfTheLayerBelow) {
    fill(painting, "PB29", kShape);
    const film::FilmState below = painting.snapshot().film;
    painting.apply(AddLayer{"Upper"});
    fill(painting, "PY35", kOver);
    const film::FilmState whole = painting.snapshot().film, paint = painting.film();
    painting.apply(clipped(2));
    const film::FilmState seen = painting.snapshot().film;
    for (int y = 0; y < seen.shape.height; ++y)
        for (int x = 0; x < seen.shape.width; ++x) {
            const bool on_paint = below.thickness.at(x, y) > 0;
            ASSERT_TRUE(same_look(seen, on_paint ? whole : below, x, y)) << x << ", " << y;
        }
    EXPECT_GT(seen.thickness.at(kShownX, kY), 0);
    EXPECT_EQ(seen.thickness.at(kHiddenX, kY), 0);
    EXPECT_EQ(film::state_hash(painting.film()), film::state_hash(paint)) << "all of it is kept";
    painting.apply(SetLayer{2, {.name = "Upper"}});
    expect_same_look(painting.snapshot().film, whole);
    expect_balance();
}

TEST_F(ClippedLayers, FollowWhatBecomesOfTheLayerBelow) {
    lay_both(painting);
    painting.apply(clipped(2));
    const std::uint64_t first = looks();
    expect_whole_view("clipped");
    painting.apply(SelectLayer{1});
    EXPECT_EQ(looks(), first);
    fill(painting, "PB29", box(4, 6, 8, 9));
    expect_whole_view("more below");
    EXPECT_EQ(painting.snapshot().film.paint.at(20, 22),
              painting.layers().layers[1].inactive->paint.at(20, 22));
    painting.apply(UseMedium{"fluid acrylic"});
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PR254"));
    painting.apply(TiltCanvas{80, 90});
    paint_wave(painting, 0.0, 12.0);
    for (int tick = 0; tick < 10; ++tick) {
        painting.advance_tick();
        if (tick % 3 == 0) expect_whole_view("flowing");
    }
    const std::uint64_t flown = looks();
    painting.apply(box(0, 0, 12, 12));
    painting.apply(ClearLayer{1});
    expect_whole_view("cleared in part");
    EXPECT_NE(looks(), flown);
    painting.apply(Undo{});
    expect_whole_view("undone");
    painting.apply(Redo{});
    expect_whole_view("redone");
    painting.apply(SelectAll{});
    painting.apply(ClearLayer{1});
    expect_whole_view("cleared");
    EXPECT_EQ(film::totals(painting.snapshot().film).thickness, 0) << "all is hidden";
    expect_balance();
}

TEST_F(ClippedLayers, WhatIsHiddenCarriesNothing) {
    const film::FilmState bare = painting.film();
    lay_both(painting);
    painting.apply(clipped(2));
    painting.apply(AddLayer{"Top"});
    const film::SupportHeights& support_mm = painting.film().support_mm;
    EXPECT_EQ(support_mm.at(kHiddenX, kY), bare.support_mm.at(kHiddenX, kY));
    EXPECT_NEAR(support_mm.at(kShownX, kY), bare.support_mm.at(kShownX, kY) + 2.0 * kFilm_mm, 1e-5);
    painting.apply(SetLayer{2, {.name = "Upper"}});
    EXPECT_NEAR(painting.film().support_mm.at(kHiddenX, kY), bare.support_mm.at(kHiddenX, kY) + kFilm_mm,
                1e-5);
    painting.apply(Undo{});
    EXPECT_EQ(painting.film().support_mm.at(kHiddenX, kY), bare.support_mm.at(kHiddenX, kY));
    painting.apply(FillWithPaint{.paint = {{{"PW6", 1.0}}}, .thickness_mm = kFilm_mm});
    EXPECT_NEAR(painting.snapshot().film.support_mm.at(kHiddenX, kY), bare.support_mm.at(kHiddenX, kY),
                1e-5);
    expect_whole_view("a layer on top");
}

TEST_F(ClippedLayers, MergedDownLeaveWhatShowsAndNothingElse) {
    Painting cut(small_canvas(), pool);
    lay_both(painting);
    lay_both(cut, kBoth);
    painting.apply(clipped(2));
    const Account before = painting.account();
    for (Painting* one : {&painting, &cut})
        one->apply(MergeDown{2});
    EXPECT_EQ(painting.state_hash(), cut.state_hash());
    EXPECT_FALSE(painting.layers().layers[0].look.clipped);
    const Account after = painting.account();
    EXPECT_EQ(after.taken.volume_mm3, before.taken.volume_mm3);
    EXPECT_NEAR(after.ledger.volume_mm3 - before.ledger.volume_mm3, kHiddenCells * kFilm_mm / 9.0,
                kRounding);
    EXPECT_NEAR(after.canvas.volume_mm3, cut.account().canvas.volume_mm3, kRounding);
    expect_balance();
    const std::uint64_t merged = painting.state_hash();
    painting.apply(Undo{});
    EXPECT_EQ(painting.account().ledger.volume_mm3, before.ledger.volume_mm3);
    EXPECT_TRUE(painting.layers().layers[1].look.clipped);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), merged);
    expect_balance();
}

TEST_F(ClippedLayers, DryOnesAreMergedWithoutALossToo) {
    lay_both(painting);
    painting.apply(DryNow{});
    painting.apply(clipped(2));
    painting.apply(SetLayer{1, {.name = "Paint", .opacity = 0.5}});
    painting.apply(MergeDown{2});
    EXPECT_EQ(painting.layers().layers[0].look.opacity, 1.0);
    expect_balance();
}

TEST_F(ClippedLayers, TwoOfOneLayerAreMergedIntoOneOfIt) {
    lay_both(painting);
    painting.apply(clipped(2));
    painting.apply(AddLayer{"More"});
    fill(painting, "PW6", box(12, 2, 30, 14));
    painting.apply(clipped(3, "More"));
    painting.apply(SetLayer{1, {.name = "Paint", .opacity = 0.5}});
    const Account before = painting.account();
    painting.apply(MergeDown{3});
    EXPECT_THAT(order(), ElementsAre(1U, 2U));
    EXPECT_TRUE(painting.layers().layers[1].look.clipped);
    EXPECT_EQ(painting.layers().layers[0].look.opacity, 0.5);
    EXPECT_EQ(painting.account().ledger.volume_mm3, before.ledger.volume_mm3) << "all is kept";
    EXPECT_EQ(painting.account().canvas.volume_mm3, before.canvas.volume_mm3);
    expect_whole_view("merged");
    expect_balance();
}

TEST_F(ClippedLayers, WhatIsMergedOntoOneIsNotClippedByIt) {
    lay_both(painting);
    painting.apply(clipped(2));
    painting.apply(AddLayer{"Free"});
    fill(painting, "PW6", box(25, 5, 35, 25));
    const double ledger_mm3 = painting.account().ledger.volume_mm3;
    painting.apply(MergeDown{3});
    EXPECT_FALSE(painting.layers().layers[1].look.clipped);
    EXPECT_GT(painting.snapshot().film.thickness.at(90, kY), 0);
    EXPECT_EQ(painting.snapshot().film.thickness.at(kHiddenX, kY), 0);
    EXPECT_NEAR(painting.account().ledger.volume_mm3 - ledger_mm3, kHiddenCells * kFilm_mm / 9.0,
                kRounding);
    expect_balance();
}

TEST_F(ClippedLayers, FlattenedAndCopiedTheyAreWhatShows) {
    lay_both(painting);
    painting.apply(clipped(2));
    painting.apply(CopyPaint{0});
    EXPECT_EQ(painting.snapshot().copied->thickness.at(kHiddenX, kY), 0);
    EXPECT_GT(painting.snapshot().copied->thickness.at(kShownX, kY), 0);
    painting.apply(CopyPaint{2});
    EXPECT_GT(painting.snapshot().copied->thickness.at(kHiddenX, kY), 0) << "a layer is copied whole";
    const double ledger_mm3 = painting.account().ledger.volume_mm3;
    painting.apply(FlattenLayers{});
    EXPECT_THAT(order(), ElementsAre(1U));
    EXPECT_EQ(painting.film().thickness.at(kHiddenX, kY), 0);
    EXPECT_NEAR(painting.account().ledger.volume_mm3 - ledger_mm3, kHiddenCells * kFilm_mm / 9.0,
                kRounding);
    expect_balance();
}

TEST_F(ClippedLayers, AreUndoneAndDoneAgain) {
    lay_both(painting);
    const std::uint64_t before = painting.state_hash(), looked = looks();
    painting.apply(clipped(2));
    const std::uint64_t after = painting.state_hash(), clipped_looks = looks();
    EXPECT_NE(after, before);
    EXPECT_NE(clipped_looks, looked);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    EXPECT_EQ(looks(), looked);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
    EXPECT_EQ(looks(), clipped_looks);
}

TEST_F(ClippedLayers, WithNothingBelowShowAll) {
    fill(painting, "PB29", kShape);
    const film::FilmState before = painting.snapshot().film;
    painting.apply(clipped(1, "Paint"));
    expect_same_look(painting.snapshot().film, before);
    painting.apply(AddLayer{"Upper"});
    fill(painting, "PY35", kOver);
    const std::uint64_t both = looks();
    painting.apply(clipped(2));
    EXPECT_EQ(looks(), both);
    EXPECT_EQ(clipped_to(painting.layers(), 1), std::nullopt);
}

TEST_F(ClippedLayers, HideAndFadeWithTheLayerBelow) {
    lay_both(painting);
    painting.apply(SetLayer{2, {.name = "Upper", .opacity = 0.5, .clipped = true}});
    painting.apply(SetLayer{1, {.name = "Paint", .opacity = 0.5}});
    EXPECT_EQ(effective_look(painting.layers(), 1).opacity, 0.25);
    painting.apply(GroupLayers{"G", {1, 2}});
    painting.apply(SetGroup{1, {.name = "G", .opacity = 0.5}});
    EXPECT_EQ(effective_look(painting.layers(), 1).opacity, 0.125);
    expect_whole_view("faded");
    painting.apply(SetLayer{1, {.name = "Paint", .visible = false}});
    EXPECT_FALSE(effective_look(painting.layers(), 1).visible);
    EXPECT_EQ(film::totals(painting.snapshot().film).thickness, 0);
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    EXPECT_EQ(error(PenDown{wave_sample(0.0, 10.0, 0)}),
              "the layer \"Upper\" is clipped to \"Paint\", which is hidden.");
}

TEST_F(ClippedLayers, AreClippedWithinTheirGroup) {
    LayerStack stack;
    const auto add = [&](GroupId group, bool is_clipped) {
        stack.layers.push_back(
            {.id = stack.next_layer++, .group = group, .look = {.clipped = is_clipped}});
    };
    add(0, false);
    add(0, true);
    add(1, true);
    add(1, false);
    add(1, true);
    add(1, true);
    add(0, true);
    std::vector<int> onto;
    for (std::size_t place = 0; place < stack.layers.size(); ++place) {
        const auto base = clipped_to(stack, place);
        onto.push_back(base ? static_cast<int>(*base) : -1);
    }
    EXPECT_THAT(onto, ElementsAre(-1, 0, -1, -1, 3, 3, 0));
    EXPECT_EQ(clipping_base(stack, 3), std::nullopt);
    EXPECT_EQ(clipping_base(stack, 0), std::nullopt);
}

TEST_F(ClippedLayers, GroupsAreNotClipped) {
    painting.apply(GroupLayers{"G", {1}});
    EXPECT_EQ(error(SetGroup{1, {.name = "G", .clipped = true}}),
              "a group of layers cannot be clipped; its layers can.");
    LayerStack stack = painting.layers();
    stack.groups[0].look.clipped = true;
    EXPECT_EQ(error_of([&] { check_stack(stack); }),
              "a group of layers cannot be clipped; its layers can.");
}

TEST_F(ClippedLayers, ANewLayerBetweenLeavesThemClippedToTheSame) {
    lay_both(painting);
    painting.apply(clipped(2));
    const std::uint64_t before = looks();
    painting.apply(SelectLayer{1});
    painting.apply(AddLayer{"Between"});
    EXPECT_THAT(order(), ElementsAre(1U, 3U, 2U));
    EXPECT_TRUE(painting.layers().layers[1].look.clipped);
    EXPECT_EQ(looks(), before);
    painting.apply(SelectLayer{2});
    painting.apply(AddLayer{"On top"});
    EXPECT_FALSE(painting.layers().layers[3].look.clipped);
}

TEST_F(ClippedLayers, ReplayAtAnyResolution) {
    Recording recording;
    recording.canvas = small_canvas();
    const FillWithPaint blue{.paint = {{{"PB29", 1.0}}}, .thickness_mm = kFilm_mm};
    const FillWithPaint yellow{.paint = {{{"PY35", 1.0}}}, .thickness_mm = kFilm_mm};
    recording.events = {{0, kShape},     {0, blue},  {0, SelectAll{}}, {0, AddLayer{"Upper"}},
                        {0, clipped(2)}, {0, kOver}, {0, yellow}};
    recording.end_tick = 0;
    for (const double px_per_mm : {3.0, 5.0}) {
        recording.canvas.px_per_mm = px_per_mm;
        Painting replayed(recording.canvas, pool);
        Player player(replayed, recording);
        while (!player.finished())
            player.play_tick();
        const film::FilmState& seen = replayed.snapshot().film;
        const auto thickness_at = [&](double x_mm, double y_mm) {
            return seen.thickness.at(static_cast<int>(x_mm * px_per_mm),
                                     static_cast<int>(y_mm * px_per_mm));
        };
        EXPECT_EQ(thickness_at(7.0, 15.0), 0) << px_per_mm;
        EXPECT_GT(thickness_at(12.0, 15.0), 0) << px_per_mm;
        EXPECT_GT(replayed.film().thickness.at(static_cast<int>(7.0 * px_per_mm),
                                               static_cast<int>(15.0 * px_per_mm)),
                  0);
    }
}

}  // namespace
}  // namespace pastoso::document
