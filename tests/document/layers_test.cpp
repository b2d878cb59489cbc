#include "document/error_of.hpp"
#include "document/layered_canvas.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/player.hpp"
#include "document/recorder.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>

namespace pastoso::document {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// As in painting_test.cpp.
constexpr double kRounding = 1e-9;

class LayersTest : public testing::Test {
  protected:
    void SetUp() override {
        painting.apply(TakeBrush{"flat", 8, 1});
        painting.apply(UseMedium{"fluid acrylic"});
    }
    void paint(const char* pigment, double start_s, double y_mm, int ticks = 3) {
        painting.apply(load_of(pigment));
        paint_wave(painting, start_s, y_mm);
        for (int i = 0; i < ticks; ++i)
            painting.advance_tick();
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    LayerStack stack() const { return painting.state().value.layers; }
    std::vector<LayerId> order() const {
        std::vector<LayerId> ids;
        for (const Layer& layer : stack().layers)
            ids.push_back(layer.id);
        return ids;
    }
    LayerId active() const { return stack().layers[stack().active].id; }
    /// A hash of all that is seen: motion is not.
    std::uint64_t looks() const {
        film::FilmState seen = painting.snapshot().film;
        seen.velocity_x = seen.velocity_y = grid::TiledField<float>(seen.shape);
        return film::state_hash(seen);
    }
    std::string error(const Action& action) {
        const std::uint64_t before = painting.state_hash();
        const std::string sentence = error_of([&] { painting.apply(action); });
        EXPECT_EQ(painting.state_hash(), before);
        return sentence;
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
};

/// It was made inactive while no paint on the canvas had structure.
TEST_F(LayersTest, ALayerThatIsTakenAgainHasTheStructureOfItsPaint) {
    paint("PB29", 0.0, 10.0);
    painting.apply(AddLayer{"Second"});
    painting.apply(UseMedium{"heavy-body oil"});
    painting.apply(SelectLayer{1});
    EXPECT_FALSE(painting.film().worked.is_anywhere());
    paint("PY35", 1.0, 12.0);
    EXPECT_TRUE(painting.film().worked.is_anywhere());
    painting.apply(UseMedium{"fluid acrylic"});
    EXPECT_TRUE(painting.film().worked.is_anywhere());
}

TEST_F(LayersTest, OnlyTheActiveLayersPaintFlows) {
    painting.apply(TiltCanvas{80, 90});
    paint("PB29", 0.0, 10.0);
    painting.apply(AddLayer{"Second"});
    const auto inactive = stack().layers[0].inactive;
    paint("PY35", 1.0, 12.0, 20);
    EXPECT_EQ(stack().layers[0].inactive, inactive);
    EXPECT_GT(film::totals(*inactive).thickness, 0);
    painting.apply(SelectLayer{1});
    const std::uint64_t before = film::state_hash(painting.film());
    painting.advance_tick();
    EXPECT_NE(film::state_hash(painting.film()), before);
    expect_balance();
}

TEST_F(LayersTest, PaintLiesOnWhatIsVisibleBelow) {
    paint("PB29", 0.0, 10.0);
    painting.apply(DryNow{});
    const film::FilmState dry = painting.film();
    painting.apply(AddLayer{"Second"});
    for (int y = 0; y < dry.shape.height; ++y)
        for (int x = 0; x < dry.shape.width; ++x)
            ASSERT_EQ(painting.film().support_mm.at(x, y), dry.support_mm.at(x, y));
    EXPECT_FALSE(film::has_wet_paint(painting.film()));
    painting.apply(SetLayer{1, {.name = "Paint", .visible = false}});
    const film::FilmState bare = Painting(small_canvas(), pool).film();
    for (int y = 0; y < dry.shape.height; ++y)
        for (int x = 0; x < dry.shape.width; ++x)
            ASSERT_EQ(painting.film().support_mm.at(x, y), bare.support_mm.at(x, y));
}

TEST_F(LayersTest, AHiddenLayerShowsWhatLiesBelowAndComesBack) {
    paint("PB29", 0.0, 10.0);
    const std::uint64_t below = looks();
    painting.apply(AddLayer{"Second"});
    EXPECT_EQ(looks(), below);
    paint("PY35", 1.0, 12.0);
    const std::uint64_t both = looks();
    EXPECT_NE(both, below);
    painting.apply(SetLayer{2, {.name = "Second", .visible = false}});
    EXPECT_EQ(looks(), below);
    painting.apply(SetLayer{2, {.name = "Second"}});
    EXPECT_EQ(looks(), both);
}

TEST_F(LayersTest, EveryChangeIsUndoneAndDoneAgain) {
    paint("PB29", 0.0, 10.0);
    painting.apply(AddLayer{"Second"});
    paint("PY35", 1.0, 12.0);
    painting.apply(DuplicateLayer{1});
    const std::vector<Action> changes = {
        AddLayer{"More"},
        SetLayer{2, {.name = "Faded", .opacity = 0.5}},
        ClearLayer{1},
        MoveLayer{1, 2, 0},
        GroupLayers{"Both", {1, 2}},
        SetGroup{1, {.name = "Both", .visible = false}},
        SetGroup{1, {.name = "Both"}},
        MoveGroup{1, 0},
        UngroupLayers{1},
        MergeDown{2},
        RemoveLayer{3},
        FlattenLayers{},
    };
    for (const Action& change : changes) {
        const std::uint64_t before = painting.state_hash(), looked = looks();
        painting.apply(change);
        const std::uint64_t after = painting.state_hash();
        EXPECT_NE(after, before) << change.index();
        expect_balance();
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), before) << change.index();
        EXPECT_EQ(looks(), looked) << change.index();
        painting.apply(Redo{});
        EXPECT_EQ(painting.state_hash(), after) << change.index();
        expect_balance();
    }
    while (painting.can_undo())
        painting.apply(Undo{});
    EXPECT_EQ(painting.account().canvas.volume_mm3, 0.0);
    EXPECT_THAT(order(), ElementsAre(1U));
}

TEST_F(LayersTest, ComeToLieWhereTheyAreMoved) {
    for (const char* name : {"B", "C", "D"})
        painting.apply(AddLayer{name});
    EXPECT_THAT(order(), ElementsAre(1U, 2U, 3U, 4U));
    painting.apply(MoveLayer{4, 0, 0});
    EXPECT_THAT(order(), ElementsAre(4U, 1U, 2U, 3U));
    EXPECT_EQ(active(), 4U);
    painting.apply(GroupLayers{"G", {1, 2}});
    painting.apply(MoveLayer{3, 1, 1});
    EXPECT_THAT(order(), ElementsAre(4U, 3U, 1U, 2U));
    painting.apply(MoveGroup{1, 0});
    EXPECT_THAT(order(), ElementsAre(3U, 1U, 2U, 4U));
    EXPECT_THAT(error(MoveLayer{4, 1, 0}), HasSubstr("tear a group of layers apart"));
    painting.apply(SelectLayer{1});
    painting.apply(AddLayer{"In the group"});
    EXPECT_EQ(stack().layers[2].group, 1U);
    painting.apply(UngroupLayers{1});
    EXPECT_TRUE(stack().groups.empty());
}

TEST_F(LayersTest, GroupsSayWhatHoldsForTheirLayers) {
    painting.apply(AddLayer{"B"});
    painting.apply(GroupLayers{"G", {1, 2}});
    painting.apply(SetGroup{1, {.name = "G", .opacity = 0.5}});
    painting.apply(SetLayer{2, {.name = "B", .locked = true, .opacity = 0.5}});
    EXPECT_EQ(effective_look(stack(), 1), (LayerLook{"B", true, true, 0.25}));
    EXPECT_EQ(effective_look(stack(), 0), (LayerLook{"Paint", true, false, 0.5}));
    painting.apply(SetGroup{1, {.name = "G", .visible = false}});
    EXPECT_FALSE(effective_look(stack(), 0).visible);
}

TEST_F(LayersTest, LockedAndHiddenLayersAreNotPaintedOn) {
    painting.apply(load_of("PB29"));
    painting.apply(SetLayer{1, {.name = "Paint", .locked = true}});
    EXPECT_EQ(error(PenDown{wave_sample(0.0, 10.0, 0)}), "the layer \"Paint\" is locked.");
    EXPECT_EQ(error(DryNow{}), "the layer \"Paint\" is locked.");
    EXPECT_EQ(error(ClearLayer{1}), "the layer \"Paint\" is locked.");
    painting.apply(SetLayer{1, {.name = "Paint", .visible = false}});
    EXPECT_EQ(error(PenDown{wave_sample(0.0, 10.0, 0)}), "the layer \"Paint\" is hidden.");
    painting.apply(PenDown{wave_sample(0.0, 10.0, 0), Surface::Well});
    painting.apply(PenUp{});
}

TEST_F(LayersTest, WhatCannotBeIsRefusedInASentence) {
    EXPECT_EQ(error(SelectLayer{7}), "there is no layer 7.");
    EXPECT_EQ(error(RemoveLayer{1}), "a painting keeps its last layer.");
    EXPECT_EQ(error(MergeDown{1}), "there is no layer below \"Paint\" to merge it onto.");
    EXPECT_EQ(error(SetGroup{2, {.name = "x"}}), "there is no group 2 of layers.");
    EXPECT_EQ(error(GroupLayers{"x", {}}), "a group needs a layer.");
    EXPECT_THAT(error(MoveLayer{1, 1, 0}), HasSubstr("there is no place 1"));
    EXPECT_THAT(error(SetLayer{1, {.name = "x", .opacity = 1.5}}), HasSubstr("opacity of the layer"));
    EXPECT_THAT(error(AddLayer{std::string(300, 'x')}), HasSubstr("has 300 bytes"));
    painting.apply(SetLayer{1, {.name = "Paint", .visible = false}});
    EXPECT_EQ(error(FlattenLayers{}), "there is no visible layer to flatten.");
}

TEST_F(LayersTest, NoChangeOfLayersLosesPaint) {
    paint("PB29", 0.0, 8.0);
    painting.apply(DryNow{});
    paint("PR254", 1.0, 9.0);
    painting.apply(AddLayer{"Second"});
    paint("PY35", 2.0, 9.5);
    painting.apply(DryNow{});
    paint("PW6", 3.0, 10.0);
    painting.apply(DuplicateLayer{2});
    painting.apply(SetLayer{3, {.name = "Copy", .opacity = 0.4}});
    const Account before = painting.account();
    expect_balance();
    painting.apply(MergeDown{3});
    painting.apply(MergeDown{2});
    const Account after = painting.account();
    expect_balance();
    EXPECT_THAT(order(), ElementsAre(1U));
    EXPECT_EQ(after.taken.volume_mm3, before.taken.volume_mm3);
    for (int k = 0; k < pigment::kChannels; ++k)
        EXPECT_NEAR(after.canvas.pigment[k] + after.dried.pigment[k],
                    before.canvas.pigment[k] + before.dried.pigment[k],
                    kRounding * before.taken.pigment[k]);
    painting.apply(ClearLayer{1});
    EXPECT_EQ(painting.account().canvas.volume_mm3 + painting.account().dried.volume_mm3, 0.0);
    expect_balance();
}

TEST_F(LayersTest, FlattenKeepsWhatIsHidden) {
    paint("PB29", 0.0, 8.0);
    for (const char* name : {"B", "C", "D"}) {
        painting.apply(AddLayer{name});
        paint("PY35", active(), 6.0 + 3.0 * active());
    }
    painting.apply(SetLayer{2, {.name = "B", .visible = false}});
    painting.apply(SetLayer{1, {.name = "Paint", .opacity = 0.5}});
    painting.apply(FlattenLayers{});
    EXPECT_THAT(order(), ElementsAre(1U, 2U));
    EXPECT_EQ(active(), 1U);
    EXPECT_EQ(stack().layers[0].look.opacity, 1.0);
    EXPECT_FALSE(stack().layers[1].look.visible);
    expect_balance();
}

TEST_F(LayersTest, ALayerOfAFadedGroupKeepsItsLookWhenItIsMergedOutOfIt) {
    paint("PB29", 0.0, 8.0);
    painting.apply(DryNow{});
    painting.apply(AddLayer{"B"});
    painting.apply(GroupLayers{"G", {1}});
    painting.apply(SetGroup{1, {.name = "G", .opacity = 0.5}});
    paint("PY35", 1.0, 20.0);
    painting.apply(MergeDown{2});
    EXPECT_EQ(effective_look(stack(), 0), (LayerLook{"Paint"}));
    EXPECT_TRUE(stack().groups.empty());
    expect_balance();
}

Recording layered_session() {
    Recording recording = crossing_session();
    const std::int64_t end = recording.end_tick;
    auto& events = recording.events;
    events.push_back({end, AddLayer{"Second"}});
    events.push_back({end, load_of("PR254")});
    for (int i = 0; i <= 30; ++i) {
        const brush::PenSample sample = wave_sample(10.0, 11.0, i);
        const Action pen = i == 0 ? Action(PenDown{sample}) : Action(PenMove{sample});
        events.push_back({end + i, pen});
    }
    events.push_back({end + 31, PenUp{}});
    events.push_back({end + 31, SetLayer{1, {.name = "Paint", .opacity = 0.7}}});
    events.push_back({end + 33, DuplicateLayer{2}});
    events.push_back({end + 34, SelectLayer{1}});
    events.push_back({end + 40, MergeDown{3}});
    recording.end_tick = end + 60;
    return recording;
}

std::uint64_t hash_after(const Recording& recording, int threads) {
    core::ThreadPool pool(threads);
    Painting painting(recording.canvas, pool);
    Player player(painting, recording);
    while (!player.finished())
        player.play_tick();
    return painting.state_hash();
}

TEST(LayeredReplay, IsTheSameOnAnyNumberOfThreads) {
    const std::uint64_t one = hash_after(layered_session(), 1);
    EXPECT_EQ(hash_after(layered_session(), 2), one);
    EXPECT_EQ(hash_after(layered_session(), 3), one);
}

TEST(LayeredReplay, GoesOnFromAStateToTheSameBits) {
    const Recording recording = layered_session();
    core::ThreadPool pool(2);
    Painting first(recording.canvas, pool);
    Player player(first, recording);
    const std::int64_t middle = recording.end_tick - 22;
    while (first.tick() < middle)
        player.play_tick();
    Painting second(first.state(), pool);
    EXPECT_EQ(second.state_hash(), first.state_hash());
    EXPECT_EQ(film::state_hash(second.snapshot().film), film::state_hash(first.snapshot().film));
    for (Painting* painting : {&first, &second}) {
        painting->apply(MergeDown{2});
        for (int i = 0; i < 10; ++i)
            painting->advance_tick();
        painting->apply(SelectLayer{1});
        painting->advance_tick();
    }
    EXPECT_EQ(second.state_hash(), first.state_hash());
}

}  // namespace
}  // namespace pastoso::document
