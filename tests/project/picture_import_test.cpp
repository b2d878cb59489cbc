#include "project/picture_import.hpp"

#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/image.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;

TEST(CanvasSize, IsThatOfThePicture) {
    const auto size = [](int width, int height, CanvasSize said, double wished_mm) {
        const CanvasSize canvas = canvas_size(width, height, said, wished_mm);
        return std::pair(canvas.width_mm, canvas.height_mm);
    };
    EXPECT_EQ(size(400, 100, {}, 0.0), std::pair(300.0, 75.0));
    EXPECT_EQ(size(100, 400, {}, 0.0), std::pair(75.0, 300.0));
    EXPECT_EQ(size(400, 100, {50.001, 12.499}, 0.0), std::pair(50.0, 12.5));
    EXPECT_EQ(size(400, 100, {}, 80.0), std::pair(80.0, 20.0));
    EXPECT_EQ(size(400, 100, {50.0, 25.0}, 80.0), std::pair(80.0, 40.0));
}

TEST(FittedPlace, IsInTheMiddle) {
    const document::CanvasSettings canvas{.width_mm = 300, .height_mm = 200};
    EXPECT_EQ(fitted_place(600, 100, canvas), (layers::PicturePlace{0, 75, 300, 50}));
    EXPECT_EQ(fitted_place(100, 200, canvas), (layers::PicturePlace{100, 0, 100, 200}));
}

class PictureImport : public testing::Test {
  protected:
    void SetUp() override {
        pigment::Picture picture{300, 200, std::vector<std::uint8_t>(std::size_t{4} * 300 * 200, 255)};
        core::write_text_file(path, files::png_file(picture));
    }

    core::ThreadPool pool{2};
    tests::TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "photo.png";
};

TEST_F(PictureImport, IsOneLayerOfPaintWithNoMorePixelsThanCells) {
    const LoadedProject project = import_picture(path, {.px_per_mm = 0.5}, pool);
    EXPECT_EQ(project.painting.value.bare->settings.support, "linen");
    ASSERT_EQ(project.painting.value.layers.layers.size(), 1U);
    EXPECT_EQ(project.painting.value.layers.layers[0].look.name, "photo");
    ASSERT_EQ(project.strokes.events.size(), 2U);
    const auto& paint = std::get<document::PaintPicture>(project.strokes.events[0].action);
    EXPECT_EQ(paint.picture->width, 150);
    EXPECT_EQ(paint.picture->height, 100);
    EXPECT_EQ(paint.place, (layers::PicturePlace{0, 0, 300, 200}));
}

TEST_F(PictureImport, AsASupportIsItsHeights) {
    ImportSettings settings{.as = ImportSettings::As::Support, .px_per_mm = 0.5};
    settings.support_relief_mm = 1.5;
    const LoadedProject project = import_picture(path, settings, pool);
    EXPECT_EQ(project.painting.value.bare->settings.support, "image");
    // Steps of 16 bits.
    EXPECT_NEAR(project.painting.value.film.support_mm.at(20, 20), 1.5F, 1e-4F);
    EXPECT_TRUE(project.strokes.events.empty());
}

TEST_F(PictureImport, SaysWhatCannotBe) {
    const auto error = [&](const std::filesystem::path& file, const ImportSettings& settings) {
        return document::error_of([&] { import_picture(file, settings, pool); });
    };
    EXPECT_THAT(error(folder.path() / "none.png", {}), HasSubstr("none.png"));
    EXPECT_THAT(error(path, {.px_per_mm = 1000}), HasSubstr("1000"));
    EXPECT_THAT(error(path, {.width_mm = 1e5}), HasSubstr("width of the canvas is 1e+05 mm"));
    EXPECT_THAT(error(path, {.support = "glass"}), HasSubstr("glass"));
}

}  // namespace
}  // namespace pastoso::project
