// In which light and in which colours pictures are made: --light, --profile, --depth.
#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/colour_profile.hpp"
#include "files/image.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace pastoso::cli {
namespace {

using pigment::WorkingSpace;
using testing::HasSubstr;

class CliPictureOptions : public CliTest {
  protected:
    /// Replays a stroke of phthalo green, whose colour is beyond sRGB.
    nlohmann::json paint(const std::string& picture, std::vector<std::string> options) const {
        options.insert(options.begin(), {"replay", short_recording(), "-q", "--paint", "PG7"});
        options.insert(options.end(), {"-o", path(picture), "--stats", path("stats.json")});
        const RunResult run = run_cli(small(options));
        EXPECT_EQ(run.status, 0) << run.errors;
        return nlohmann::json::parse(core::read_text_file(path("stats.json")));
    }

    pigment::LinearImage picture(const std::string& name,
                                 WorkingSpace space = WorkingSpace::Srgb) const {
        return files::read_colour_image(path(name), space);
    }

    std::string even_light() const {
        std::string csv = "wavelength_nm,power\n";
        for (int nm = 400; nm <= 700; nm += 20)
            csv += std::to_string(nm) + ",1\n";
        return write("even.csv", csv);
    }
};

/// The greatest difference of two pictures' values.
float apart(const pigment::LinearImage& a, const pigment::LinearImage& b) {
    float largest = 0.0F;
    EXPECT_EQ(a.rgb.size(), b.rgb.size());
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
    return largest;
}

TEST_F(CliPictureOptions, AnotherLightShowsTheSamePaintInOtherColours) {
    const auto usual = paint("usual.png", {});
    const auto day = paint("day.png", {"--light", "D65"});
    EXPECT_EQ(usual["image_hash"], day["image_hash"]);
    EXPECT_EQ(core::read_text_file(path("usual.png")), core::read_text_file(path("day.png")));
    for (const std::string& light :
         {std::string("A"), std::string("d50"), std::string("LED"), even_light()}) {
        const auto other = paint("other.png", {"--light", light});
        EXPECT_EQ(other["state_hash"], usual["state_hash"]) << light;
        EXPECT_NE(other["image_hash"], usual["image_hash"]) << light;
    }
}

TEST_F(CliPictureOptions, DisplayP3HoldsTheSameColours) {
    paint("srgb.png", {"--depth", "16"});
    paint("p3.png", {"--depth", "16", "--profile", "display-p3"});
    EXPECT_NE(core::read_text_file(path("srgb.png")), core::read_text_file(path("p3.png")));
    const auto srgb = picture("srgb.png"), p3 = picture("p3.png");
    // The bare canvas in the corner is inside both gamuts.
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(srgb.rgb[channel], p3.rgb[channel], 2e-3F);
}

TEST_F(CliPictureOptions, SixteenBitsAreFinerThanEight) {
    paint("fine.png", {"--depth", "16"});
    paint("coarse.png", {});
    paint("linear.exr", {});
    const auto linear = picture("linear.exr"), fine = picture("fine.png"),
               coarse = picture("coarse.png");
    const float corner[] = {linear.rgb[0], fine.rgb[0], coarse.rgb[0]};
    EXPECT_NEAR(corner[1], corner[0], 6e-4F);  // half a step of EXR's halves, and the profile's rounding
    EXPECT_NEAR(corner[2], corner[0], 5e-3F);
    EXPECT_LT(apart(fine, coarse), 6e-3F);
}

TEST_F(CliPictureOptions, PicturesAreConvertedToAProfile) {
    const std::string icc = write("p3.icc", files::icc_profile(WorkingSpace::DisplayP3));
    paint("converted.tif", {"--profile", icc, "--depth", "16"});
    paint("rendered.tif", {"--profile", "display-p3", "--depth", "16"});
    EXPECT_THAT(core::read_text_file(path("converted.tif")),
                HasSubstr(files::icc_profile(WorkingSpace::DisplayP3)));
    // Two ways to the same colours; the profile's numbers have 16 binary digits.
    EXPECT_LT(apart(picture("converted.tif", WorkingSpace::DisplayP3),
                    picture("rendered.tif", WorkingSpace::DisplayP3)),
              2e-3F);
}

TEST_F(CliPictureOptions, BadLightsAndProfilesAreRefusedBeforeAnything) {
    const std::string pen = short_recording();
    expect_refusal(small({"replay", pen, "--light", "D99", "-o", path("a.png")}), 1,
                   "There is no light \"D99\"; there are D65, D50, A and LED");
    const std::string csv = write("bad.csv", "wavelength_nm,power\n400,1\n410,x\n");
    expect_refusal(small({"replay", pen, "--light", csv, "-o", path("a.png")}), 1,
                   "bad.csv, line 3: the power \"x\" is not a finite number.");
    const std::string none = write("none.icc", "this is no profile");
    expect_refusal(small({"replay", pen, "--profile", none, "-o", path("a.png")}), 1,
                   "none.icc: is no ICC profile (");
    expect_refusal(small({"replay", pen, "--profile", "adobe", "-o", path("a.png")}), 1,
                   "adobe: cannot be opened");
    expect_refusal(small({"replay", pen, "--depth", "16", "-o", path("a.jpg")}), 1,
                   "a.jpg: .jpg files do not hold 16-bit pictures.");
    expect_refusal(small({"replay", pen, "--depth", "12", "-o", path("a.png")}), 2, "12");
    expect_refusal({"simulate", "glaze", "--profile", none, "-o", path("folder")}, 1,
                   "none.icc: is no ICC profile (");
    expect_refusal({"simulate", "glaze", "--light", "D99", "-o", path("folder")}, 1,
                   "There is no light \"D99\"");
}

TEST_F(CliPictureOptions, SimulateMakesPicturesInTheLightThatIsAsked) {
    const auto simulate = [&](const char* name, const std::vector<std::string>& options) {
        std::vector<std::string> arguments = {"simulate", "glaze", "--seconds", "0",
                                              "-q",       "-o",    path(name)};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const RunResult run = run_cli(arguments);
        EXPECT_EQ(run.status, 0) << run.errors;
        return files::read_colour_image(path(name) + "/picture-0s.png");
    };
    const auto day = simulate("day", {});
    const auto lamp = simulate("lamp", {"--light", "A", "--depth", "16", "--profile", "display-p3"});
    EXPECT_GT(apart(day, lamp), 1e-2F);
    EXPECT_EQ(core::read_text_file(path("day/series.csv")),
              core::read_text_file(path("lamp/series.csv")));
}

}  // namespace
}  // namespace pastoso::cli
