#include "recordings/canvas_support.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using document::error_of;
using testing::HasSubstr;

class CanvasSupportTest : public files::TemporaryFolder {
  protected:
    document::CanvasSettings canvas_with_image(const std::string& image) const {
        document::CanvasSettings canvas;
        canvas.width_mm = 20;
        canvas.height_mm = 10;
        canvas.px_per_mm = 2;
        canvas.support = "image";
        canvas.support_image = image;
        canvas.support_relief_mm = 0.8;
        return canvas;
    }
};

TEST_F(CanvasSupportTest, AnImageIsTurnedAsItsSettingsSay) {
    pigment::Image8 image{4, 2, {}};
    for (int i = 0; i < 4 * 2; ++i)
        image.rgb.insert(image.rgb.end(), 3, static_cast<std::uint8_t>(30 * i));
    files::write_image(folder / "steps.png", image);
    core::ThreadPool pool(1);
    document::CanvasSettings canvas = canvas_with_image((folder / "steps.png").string());
    const auto upright = make_support(canvas, pool);
    canvas.support_turn = {false, 1};
    std::swap(canvas.width_mm, canvas.height_mm);
    const auto turned = make_support(canvas, pool);
    ASSERT_EQ(turned.shape(), (grid::Shape{20, 40}));
    EXPECT_EQ(turned.at(19 - 3, 7), upright.at(7, 3));
}

TEST_F(CanvasSupportTest, AnImageBecomesARelief) {
    pigment::Image8 image{64, 8, {}};
    for (int i = 0; i < 64 * 8; ++i)
        image.rgb.insert(image.rgb.end(), 3, i % 64 < 32 ? 0 : 255);
    files::write_image(folder / "steps.png", image);
    core::ThreadPool pool(1);
    const auto support = make_support(canvas_with_image((folder / "steps.png").string()), pool);
    EXPECT_EQ(support.shape(), (grid::Shape{40, 20}));
    // Far from the step the smooth interpolation gives black and white themselves, up to its overshoot.
    EXPECT_NEAR(support.at(4, 10), 0.0F, 1e-3F);
    EXPECT_NEAR(support.at(35, 10), 0.8F, 1e-3F);
    EXPECT_LT(support.at(16, 10), support.at(23, 10));
}

TEST_F(CanvasSupportTest, APaintingStandsOnIt) {
    files::write_image(folder / "white.png", pigment::Image8{2, 2, std::vector<std::uint8_t>(12, 255)});
    core::ThreadPool pool(1);
    const auto painting = make_painting(canvas_with_image((folder / "white.png").string()), pool);
    EXPECT_NEAR(painting->film().support_mm.at(20, 10), 0.8F, 1e-3F);
}

TEST_F(CanvasSupportTest, NamedSupportsAreThoseOfTheFilm) {
    document::CanvasSettings canvas = canvas_with_image("");
    canvas.support = "linen";
    core::ThreadPool pool(1);
    const auto painting = make_painting(canvas, pool);
    EXPECT_EQ(painting->state_hash(), document::Painting(canvas, pool).state_hash());
}

TEST_F(CanvasSupportTest, RefusesImagesThatAreNone) {
    core::ThreadPool pool(1);
    EXPECT_EQ(error_of([&] { make_support(canvas_with_image(""), pool); }),
              "The support \"image\" needs a height image; none is named.");
    EXPECT_THAT(error_of([&] { make_support(canvas_with_image("/nonexistent.png"), pool); }),
                HasSubstr("/nonexistent.png: cannot be opened"));
    core::write_text_file(folder / "text.png", "no picture");
    EXPECT_THAT(error_of([&] { make_support(canvas_with_image((folder / "text.png").string()), pool); }),
                HasSubstr("text.png: is not an image that can be read"));
}

}  // namespace
}  // namespace pastoso::recordings
