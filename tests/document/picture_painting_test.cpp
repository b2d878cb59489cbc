#include "core/random.hpp"
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"
#include "layers/flat_paint.hpp"
#include "shade/tile_colour.hpp"

#include <gmock/gmock.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

/// As in painting_test.cpp.
constexpr double kRounding = 1e-9;

std::shared_ptr<pigment::Picture> plain(int width, int height, std::uint8_t alpha = 255) {
    auto picture = std::make_shared<pigment::Picture>();
    picture->width = width;
    picture->height = height;
    for (int i = 0; i < width * height; ++i)
        picture->rgba.insert(picture->rgba.end(), {200, 60, 30, alpha});
    return picture;
}

class PicturePaintingTest : public testing::Test {
  protected:
    LayerStack stack() const { return painting.state().value.layers; }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }

    core::ThreadPool pool{2};
    Painting painting{small_canvas(), pool};
    const PaintPicture picture{"Photo", {5, 5, 10, 10}, plain(8, 8)};
};

TEST_F(PicturePaintingTest, IsALayerAboveTheActiveOne) {
    painting.apply(AddLayer{"Second"});
    painting.apply(SelectLayer{1});
    painting.apply(picture);
    ASSERT_EQ(stack().layers.size(), 3U);
    EXPECT_EQ(stack().layers[1].look.name, "Photo");
    EXPECT_EQ(stack().active, 1U);
    EXPECT_EQ(painting.undo_steps().back().step.name, "Picture as paint");
    EXPECT_EQ(painting.undo_steps().back().step.layer, "Photo");
}

TEST_F(PicturePaintingTest, ComesOutOfTheTubes) {
    painting.apply(picture);
    // 10 x 10 mm of kFlatPaint_mm.
    EXPECT_NEAR(painting.account().taken.volume_mm3, 100.0 * layers::kFlatPaint_mm, 1e-6);
    EXPECT_NEAR(painting.account().dried.volume_mm3, 100.0 * layers::kFlatPaint_mm, 1e-6);
    expect_balance();
}

TEST_F(PicturePaintingTest, IsUndoneAndDoneAgain) {
    const std::uint64_t before = painting.state_hash();
    painting.apply(picture);
    const std::uint64_t after = painting.state_hash();
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
    expect_balance();
}

TEST_F(PicturePaintingTest, PicturesThatComeTogetherAreOneStep) {
    const std::uint64_t before = painting.state_hash();
    PaintPicture second{"Second", {2, 8, 12, 6}, plain(8, 4), true};
    for (const PaintPicture& one : {picture, second})
        painting.apply(one);
    const std::uint64_t after = painting.state_hash();
    ASSERT_EQ(stack().layers.size(), 3U);
    EXPECT_EQ(stack().layers[2].look.name, "Second");
    EXPECT_EQ(painting.undo_steps().size(), 1U);
    painting.apply(Undo{});
    EXPECT_EQ(painting.state_hash(), before);
    expect_balance();
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), after);
    expect_balance();
    painting.apply(AddLayer{"Empty"});
    painting.apply(second);
    EXPECT_EQ(painting.undo_steps().size(), 3U) << "there was nothing of its kind to join";
}

TEST_F(PicturePaintingTest, CanBePaintedOnMovedAndMerged) {
    painting.apply(picture);
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 10.0);
    painting.apply(TransformLayer{2, {.centre_x_mm = 10, .centre_y_mm = 10, .turn_deg = 30}});
    expect_balance();
    painting.apply(MergeDown{2});
    expect_balance();
    EXPECT_EQ(stack().layers.size(), 1U);
}

TEST_F(PicturePaintingTest, RefusesWhatIsNoPictureToPaint) {
    const auto error = [&](PaintPicture paint) {
        const std::uint64_t before = painting.state_hash();
        const std::string sentence = error_of([&] { painting.apply(paint); });
        EXPECT_EQ(painting.state_hash(), before);
        return sentence;
    };
    PaintPicture wrong = picture;
    wrong.place.width_mm = 0.0;
    EXPECT_THAT(error(wrong), HasSubstr("width of the picture in mm is 0"));
    wrong = picture;
    wrong.place.x_mm = 1e9;
    EXPECT_THAT(error(wrong), HasSubstr("x of the picture in mm"));
    wrong = picture;
    wrong.picture = std::make_shared<pigment::Picture>(pigment::Picture{40000, 1, {}});
    EXPECT_THAT(error(wrong), HasSubstr("width of the picture in pixels is 40000"));
    wrong.picture = std::make_shared<pigment::Picture>(pigment::Picture{30000, 30000, {}});
    EXPECT_THAT(error(wrong), HasSubstr("number of the picture's pixels"));
}

TEST_F(PicturePaintingTest, BesideTheCanvasIsABareLayer) {
    PaintPicture beside = picture;
    beside.place.x_mm = -500;
    painting.apply(beside);
    EXPECT_EQ(painting.account().taken.volume_mm3, 0.0);
    EXPECT_EQ(stack().layers.size(), 2U);
}

}  // namespace
}  // namespace pastoso::document
