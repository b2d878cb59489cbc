// The picture that is traced: a part of the painting's setting, not of its paint.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <gmock/gmock.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

std::shared_ptr<const pigment::Picture> plain(int width, int height) {
    pigment::Picture picture{width, height, {}};
    picture.rgba.assign(std::size_t{4} * width * height, 200);
    return std::make_shared<const pigment::Picture>(std::move(picture));
}

class TracingPaintingTest : public testing::Test {
  protected:
    std::shared_ptr<const layers::Tracing> tracing() const { return painting.snapshot().tracing; }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
    const LayTracing picture{plain(8, 6), {5, 5, 16, 12}};
};

TEST_F(TracingPaintingTest, LiesBelowThePaintAndChangesNoneOfIt) {
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 10.0);
    const Snapshot before = painting.snapshot();
    const std::uint64_t hash = painting.state_hash();
    painting.apply(picture);
    ASSERT_TRUE(tracing());
    EXPECT_EQ(*tracing(), (layers::Tracing{picture.picture, picture.place, 0.5}));
    EXPECT_EQ(painting.state_hash(), hash);
    const Snapshot after = painting.snapshot();
    for (int tile = 0; tile < before.film.shape.tile_count(); ++tile)
        EXPECT_TRUE(after.film.strata.optics.shares_tile(before.film.strata.optics, tile));
    EXPECT_EQ(*painting.state().value.tracing, *tracing());
    EXPECT_EQ(*Painting(painting.state(), pool).snapshot().tracing, *tracing());
}

TEST_F(TracingPaintingTest, EveryChangeIsUndone) {
    painting.apply(picture);
    painting.apply(SetTracing{{0, 0, 8, 6}, 0.25});
    painting.apply(LayTracing{});
    EXPECT_EQ(tracing(), nullptr);
    painting.apply(Undo{});
    EXPECT_EQ(tracing()->opacity, 0.25);
    painting.apply(Undo{});
    EXPECT_EQ(tracing()->place, picture.place);
    painting.apply(Undo{});
    EXPECT_EQ(tracing(), nullptr);
    EXPECT_FALSE(painting.can_undo());
    painting.apply(Redo{});
    EXPECT_EQ(tracing()->picture, picture.picture);
    EXPECT_EQ(painting.redo_steps().back().step.name, "Place of the traced picture");
}

TEST_F(TracingPaintingTest, WhereThereIsNoneNothingIsSetAndNothingUndone) {
    painting.apply(SetTracing{{0, 0, 8, 6}, 0.25});
    painting.apply(LayTracing{});
    EXPECT_EQ(tracing(), nullptr);
    EXPECT_FALSE(painting.can_undo());
}

TEST_F(TracingPaintingTest, AnotherPictureKeepsTheOpacity) {
    painting.apply(picture);
    painting.apply(SetTracing{picture.place, 0.8});
    painting.apply(LayTracing{plain(2, 2), {0, 0, 5, 5}});
    EXPECT_EQ(tracing()->opacity, 0.8);
    EXPECT_EQ(tracing()->picture->width, 2);
}

TEST_F(TracingPaintingTest, StaysWhereItLiesOnTheClothWhenTheCanvasIsCut) {
    painting.apply(picture);
    const CanvasSettings canvas = painting.settings();
    painting.apply(ResizeCanvas{2, -3, canvas.width_mm - 2, canvas.height_mm + 3});
    EXPECT_EQ(tracing()->place, (layers::PicturePlace{3, 8, 16, 12}));
    painting.apply(Undo{});
    EXPECT_EQ(tracing()->place, picture.place);
}

TEST_F(TracingPaintingTest, CountsInTheHistoryOnceItIsGone) {
    painting.apply(picture);
    painting.apply(LayTracing{plain(512, 512), picture.place});
    painting.apply(SetTracing{picture.place, 0.1});
    painting.apply(LayTracing{});
    painting.apply(picture);
    const auto bytes = [&](std::size_t step) { return painting.undo_steps()[step].bytes; };
    constexpr std::size_t kPicture = std::size_t{4} * 512 * 512;
    EXPECT_LT(bytes(2), kPicture);
    EXPECT_GE(bytes(3), kPicture);
}

TEST_F(TracingPaintingTest, RefusesWhatCannotBeLaid) {
    const auto error = [&](const Action& action) { return error_of([&] { painting.apply(action); }); };
    LayTracing wrong = picture;
    wrong.place.width_mm = 0.0;
    EXPECT_THAT(error(wrong), HasSubstr("width of the picture in mm is 0"));
    EXPECT_THAT(error(SetTracing{picture.place, 1.5}),
                HasSubstr("opacity of the tracing picture is 1.5"));
    EXPECT_EQ(tracing(), nullptr);
}

}  // namespace
}  // namespace pastoso::document
