// Pictures that "convert" brings onto canvases.
#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "pigment/lab.hpp"

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

class CliConvert : public CliTest {
  protected:
    /// Left half red, right half clear blue, 4 px per mm.
    void write_picture() const {
        pigment::Picture picture{80, 60, {}};
        for (int i = 0; i < 80 * 60; ++i) {
            const bool left = i % 80 < 40;
            const std::uint8_t pixel[] = {static_cast<std::uint8_t>(left ? 200 : 30), 60,
                                          static_cast<std::uint8_t>(left ? 30 : 180), 255};
            picture.rgba.insert(picture.rgba.end(), pixel, pixel + 4);
        }
        core::write_text_file(path("a.png"), files::png_file(picture));
    }
};

TEST_F(CliConvert, APictureBecomesAPaintingAndLooksLikeIt) {
    write_picture();
    const RunResult run = run_cli({"convert", path("a.png"), path("a.pastoso"), "--support", "panel",
                                   "--width-mm", "20", "--px-per-mm", "4"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.output, path("a.pastoso") + ": 20 x 15 mm, 80 x 60 cells, 1 layer\n");
    ASSERT_EQ(run_cli({"convert", "-q", path("a.pastoso"), path("b.png")}).status, 0);
    const pigment::LinearImage a = files::read_colour_image(path("a.png"));
    const pigment::LinearImage b = files::read_colour_image(path("b.png"));
    ASSERT_EQ(a.rgb.size(), b.rgb.size());
    for (const int x : {10, 30, 50, 70}) {
        const auto colour = [&](const pigment::LinearImage& image) {
            const float* pixel = &image.rgb[std::size_t{3} * (30 * 80 + x)];
            return pigment::lab(pigment::LinearRgb{pixel[0], pixel[1], pixel[2]});
        };
        // White is 0.955 of the screen's, and dry paint has a sheen.
        EXPECT_LT(pigment::ciede2000(colour(a), colour(b)), 3.0) << x;
    }
}

TEST_F(CliConvert, APictureBecomesASupport) {
    write_picture();
    const RunResult run = run_cli({"convert", path("a.png"), "-o", path("a.pastoso"), "--as", "support",
                                   "--relief-mm", "2", "--px-per-mm", "0.5"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.output, path("a.pastoso") + ": 300 x 225 mm, 150 x 113 cells, 1 layer\n");
}

TEST_F(CliConvert, SaysWhatCannotBeDone) {
    const std::string text = write("a.png", "no picture");
    expect_refusal({"convert", text, path("a.pastoso")}, 1, text + ": is not an image that can be read");
    expect_refusal({"convert", write("a.ora", "none"), path("a.pastoso")}, 1, "a.ora: ");
    expect_refusal({"convert", text, path("b.png")}, 2, "name the second file NAME.pastoso.");
    expect_refusal({"convert", text}, 2, "--output is required");
    expect_refusal({"convert", path("a.ora"), path("a.pastoso"), "--as", "support"}, 2, "has layers.");
}

}  // namespace
}  // namespace pastoso::cli
