// The board of references: a part of the painting's setting, not of its paint.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>

namespace pastoso::document {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

SharedReferencePicture plain(int width, int height) {
    ReferencePicture picture{{width, height, {}}, {}};
    picture.pixels.rgba.assign(std::size_t{4} * width * height, 200);
    return std::make_shared<const ReferencePicture>(std::move(picture));
}

class ReferenceBoardTest : public testing::Test {
  protected:
    const ReferenceBoard& board() {
        shown = painting.snapshot().references;
        return *shown;
    }
    std::vector<ReferenceId> order() {
        std::vector<ReferenceId> ids;
        for (const Reference& reference : board().references)
            ids.push_back(reference.id);
        return ids;
    }
    void lay(int count) {
        for (int i = 0; i < count; ++i)
            painting.apply(LayReference{"picture", {10.0 * i, 5, 40, 0, false}, plain(8, 6)});
    }
    std::string error(const Action& action) {
        return error_of([&] { painting.apply(action); });
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
    SharedReferences shown;
};

TEST_F(ReferenceBoardTest, ChangesNothingOfThePaint) {
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 10.0);
    const std::uint64_t hash = painting.state_hash();
    EXPECT_EQ(painting.snapshot().references, nullptr);
    const LayReference sky{"sky", {5, 6, 30, 0, false}, plain(8, 6)};
    painting.apply(sky);
    EXPECT_EQ(painting.state_hash(), hash);
    EXPECT_THAT(board().references, ElementsAre(Reference{1, "sky", sky.picture, sky.place, {}}));
    EXPECT_EQ(*Painting(painting.state(), pool).snapshot().references, board());
}

TEST_F(ReferenceBoardTest, PicturesThatComeTogetherAreOneStep) {
    lay(1);
    for (const bool joins : {false, true, true})
        painting.apply(LayReference{"picture", {0, 5, 40, 0, false}, plain(8, 6), joins});
    EXPECT_EQ(painting.undo_steps().size(), 2U);
    painting.apply(Undo{});
    EXPECT_THAT(order(), ElementsAre(1));
    painting.apply(Redo{});
    EXPECT_THAT(order(), ElementsAre(1, 2, 3, 4));
    painting.apply(MoveReference{1, 1});
    painting.apply(LayReference{"picture", {}, plain(8, 6), true});
    EXPECT_EQ(painting.undo_steps().size(), 4U) << "there was nothing of its kind to join";
}

TEST_F(ReferenceBoardTest, EveryChangeIsUndoneAndDoneAgain) {
    lay(2);
    const SetReference set{1, {-3, 4, 60, 30, true}, {0.25, true}};
    painting.apply(set);
    painting.apply(MoveReference{1, 1});
    painting.apply(RemoveReference{2});
    EXPECT_THAT(order(), ElementsAre(1));
    painting.apply(Undo{});
    EXPECT_THAT(order(), ElementsAre(2, 1));
    EXPECT_EQ(board().references[1].place, set.place);
    EXPECT_EQ(board().references[1].look, set.look);
    painting.apply(Undo{});
    EXPECT_THAT(order(), ElementsAre(1, 2));
    painting.apply(Undo{});
    EXPECT_EQ(board().references[0].look, ReferenceLook{});
    painting.apply(Undo{});
    painting.apply(Undo{});
    EXPECT_EQ(painting.snapshot().references, nullptr);
    EXPECT_FALSE(painting.can_undo());
    for (int steps = 0; steps < 5; ++steps)
        painting.apply(Redo{});
    EXPECT_THAT(order(), ElementsAre(1));
    EXPECT_EQ(board().references[0].place, set.place);
    EXPECT_EQ(painting.undo_steps().front().step.name, "Reference picture");
    EXPECT_EQ(painting.undo_steps().front().step.layer, "picture");
}

TEST_F(ReferenceBoardTest, ANumberIsNeverGivenTwice) {
    lay(2);
    painting.apply(RemoveReference{2});
    lay(1);
    EXPECT_THAT(order(), ElementsAre(1, 3));
}

TEST_F(ReferenceBoardTest, MovesToAnyPlaceInTheOrder) {
    lay(3);
    painting.apply(MoveReference{1, 2});
    EXPECT_THAT(order(), ElementsAre(2, 3, 1));
    painting.apply(MoveReference{1, 1});
    EXPECT_THAT(order(), ElementsAre(2, 1, 3));
    painting.apply(MoveReference{3, 0});
    EXPECT_THAT(order(), ElementsAre(3, 2, 1));
    painting.apply(MoveReference{2, 99});
    EXPECT_THAT(order(), ElementsAre(3, 1, 2));
}

TEST_F(ReferenceBoardTest, WhatChangesNothingIsNoStep) {
    lay(1);
    const auto steps = painting.undo_steps().size();
    for (const Action& action : std::vector<Action>{
             SetReference{1, {0, 5, 40, 0, false}, {}}, SetReference{7, {0, 5, 41, 0, false}, {}},
             MoveReference{1, 5}, MoveReference{7, 0}, RemoveReference{7}})
        painting.apply(action);
    EXPECT_EQ(painting.undo_steps().size(), steps);
    EXPECT_THAT(order(), ElementsAre(1));
}

TEST_F(ReferenceBoardTest, StaysAsItIsWhenTheCanvasChanges) {
    lay(1);
    const ReferenceBoard before = board();
    painting.apply(TurnCanvas{{false, 1}});
    painting.apply(ResizeCanvas{2, 3, 20, 20});
    EXPECT_EQ(board(), before);
}

TEST_F(ReferenceBoardTest, CountsInTheHistoryOnceItIsGone) {
    painting.apply(LayReference{"large", {}, plain(512, 512)});
    painting.apply(SetReference{1, {1, 2, 30, 0, false}, {}});
    painting.apply(RemoveReference{1});
    painting.apply(LayReference{"small", {}, plain(1, 1)});
    const auto bytes = [&](std::size_t step) { return painting.undo_steps()[step].bytes; };
    constexpr std::size_t kPicture = std::size_t{4} * 512 * 512;
    EXPECT_LT(bytes(1), kPicture) << "which is still there";
    EXPECT_GE(bytes(2), kPicture);
    EXPECT_LT(bytes(3), kPicture);
}

TEST_F(ReferenceBoardTest, RefusesWhatIsOutOfRange) {
    lay(1);
    const auto set = [](ReferencePlace place, ReferenceLook look) {
        return SetReference{1, place, look};
    };
    EXPECT_THAT(error(set({0, 0, 0.5, 0, false}, {})), HasSubstr("width of the reference in mm is 0.5"));
    EXPECT_THAT(error(set({0, 0, 5, 361, false}, {})),
                HasSubstr("turn of the reference in degrees is 361"));
    EXPECT_THAT(error(set({0, 30000, 5, 0, false}, {})), HasSubstr("y of the reference in mm is 30000"));
    EXPECT_THAT(error(set({}, {1.5, false})), HasSubstr("opacity of the reference is 1.5"));
    EXPECT_THAT(error(MoveReference{1, -1}), HasSubstr("position of the reference is -1"));
    EXPECT_THAT(error(RemoveReference{0}), HasSubstr("number of the reference is 0"));
    EXPECT_EQ(board().references.size(), 1U);
}

TEST_F(ReferenceBoardTest, RefusesMoreThanItKeeps) {
    lay(kMostReferences);
    EXPECT_THAT(error(LayReference{"one more", {}, plain(1, 1)}),
                HasSubstr("the board holds 100 references"));
    EXPECT_EQ(board().references.size(), kMostReferences);
}

TEST_F(ReferenceBoardTest, RefusesMorePixelsThanItKeeps) {
    const SharedReferencePicture large = plain(9000, 7500);
    for (int i = 0; i < 2; ++i)
        painting.apply(LayReference{"large", {}, large});
    EXPECT_THAT(error(LayReference{"large", {}, large}), HasSubstr("at most 200 million pixels"));
    EXPECT_EQ(board().references.size(), 2U);
}

}  // namespace
}  // namespace pastoso::document
