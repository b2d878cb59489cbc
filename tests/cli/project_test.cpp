#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace pastoso::cli {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

class CliProject : public CliTest {};

TEST_F(CliProject, APaintingIsSavedTakenBackAndTheSamePictureMadeOfIt) {
    const RunResult run =
        run_cli(small({"replay", short_recording(), "--medium", "house paint", "--tilt", "60", "--save",
                       path("a.pastoso"), "-o", path("replayed.png"), "--stats", path("stats.json")}));
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr(path("a.pastoso") + ": the painting\n"));
    const RunResult exported = run_cli({"export", "-q", path("a.pastoso"), "-o", path("exported.png")});
    ASSERT_EQ(exported.status, 0) << exported.errors;
    EXPECT_EQ(exported.output, path("exported.png") + ": 80 x 60 pixels\n");
    EXPECT_EQ(exported.errors, "");
    EXPECT_EQ(core::read_text_file(path("exported.png")), core::read_text_file(path("replayed.png")));

    const auto stats = nlohmann::json::parse(core::read_text_file(path("stats.json")));
    const RunResult info = run_cli({"info", path("a.pastoso")});
    EXPECT_THAT(info.output, StartsWith(path("a.pastoso") + ": painting, saved by Pastoso "));
    EXPECT_THAT(info.output, HasSubstr("state: " + stats["state_hash"].get<std::string>() + "\n"));
    EXPECT_THAT(info.output, HasSubstr("medium: house paint\n"));
    EXPECT_THAT(info.output, ContainsRegex("paint: [0-9.]+ MB in [0-9.]+ MB\n"));
}

TEST_F(CliProject, ExportTakesThePicturesOptions) {
    ASSERT_EQ(run_cli(small({"replay", short_recording(), "--save", path("a.pastoso")})).status, 0);
    const RunResult run =
        run_cli({"export", path("a.pastoso"), "-o", path("big.tif"), "--depth", "16", "--scale", "2",
                 "--light", "A", "--profile", "display-p3", "--well", path("well.png")});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(files::read_grey_image(path("big.tif")).width, 160);
    EXPECT_EQ(files::read_grey_image(path("well.png")).width, 720);
}

TEST_F(CliProject, WhatCannotBeDoneIsToldInASentence) {
    const std::string pen = short_recording();
    expect_refusal(small({"replay", pen, "--save", path("a.psd")}), 1,
                   path("a.psd") + ": a painting is saved as .pastoso; this name ends otherwise.");
    expect_refusal({"export", path("none.pastoso"), "-o", path("a.png")}, 1,
                   path("none.pastoso") + ": cannot be opened (No such file or directory).");
    expect_refusal({"export", pen, "-o", path("a.png")}, 1, pen + ": is no painting of Pastoso");
    expect_refusal({"export", pen}, 2, "export needs a picture to make: -o FILE, or --well FILE.");
    expect_refusal({"info", write("a.pastoso", "PK nothing")}, 1, "is no painting of Pastoso");
}

}  // namespace
}  // namespace pastoso::cli
