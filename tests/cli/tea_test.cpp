#include "cli/liquid_test.hpp"
#include "files/image.hpp"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class CliTea : public LiquidTest {
  protected:
    /// Half a second of tea on a coarse grid.
    RunResult tea(const std::vector<std::string>& more) const {
        std::vector<std::string> all = {"tea", "--grid", "16", "--seconds", "0.5", "-q"};
        all.insert(all.end(), more.begin(), more.end());
        return run_cli(all);
    }
};

TEST_F(CliTea, StatsTellWhatHappened) {
    ASSERT_EQ(tea({"--stats", path("stats.json"), "--threads", "1"}).status, 0);
    const files::Json stats = json("stats.json");
    EXPECT_EQ(stats.at("steps"), 15);
    EXPECT_EQ(stats.at("frames"), 0);
    EXPECT_EQ(stats.at("threads"), 1);
    // The recipe pours for 1.6 s, from 5 mm above the level, at 0.16 m/s.
    const double fall_s = (std::sqrt(0.16 * 0.16 + 2.0 * 9.81 * 0.005) - 0.16) / 9.81;
    EXPECT_NEAR(stats.at("parcels").get<double>(), 400000 * (0.5 - fall_s) / 1.6, 1.0);
    EXPECT_LT(stats.at("milk_error_rel").get<double>(), 1e-6);
    EXPECT_GT(stats.at("pcg_iterations_max").get<int>(), 0);
    EXPECT_GT(stats.at("divergence_max").get<double>(), 0.0);
    EXPECT_EQ(stats.at("not_converged"), 0);
    EXPECT_GT(stats.at("steps_per_s").get<double>(), 0.0);
}

TEST_F(CliTea, ThreadsDoNotMatter) {
    ASSERT_EQ(tea({"--stats", path("one.json"), "--threads", "1"}).status, 0);
    ASSERT_EQ(tea({"--stats", path("three.json"), "--threads", "3"}).status, 0);
    EXPECT_EQ(json("one.json").at("state_hash"), json("three.json").at("state_hash"));
}

TEST_F(CliTea, EveryFormatOfSurfacesIsWritten) {
    for (const std::string format : {"obj", "ply", "stl", "pbrt"}) {
        ASSERT_EQ(tea({"--frames", path(format), "--every", "15", "--format", format}).status, 0)
            << format;
        EXPECT_THAT(files_in(format), testing::ElementsAre("milk_0015." + format));
        EXPECT_GT(fs::file_size(path(format + "/milk_0015." + format)), 1000U);
    }
    ASSERT_EQ(tea({"--frames", path("scene"), "--every", "15", "--format", "pbrt-scene"}).status, 0);
    EXPECT_THAT(bytes("scene/scene_0015.pbrt"), AllOf(HasSubstr("WorldBegin"), HasSubstr("Include")));
}

TEST_F(CliTea, PicturesAreNumberedByFramesAndThoseOfKeptFramesAreTheSame) {
    const std::vector<std::string> small = {"--size", "24x18", "--samples", "2", "--every", "5"};
    const auto with = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), small.begin(), small.end());
        return arguments;
    };
    const RunResult at_once = tea(with({"--frames", path("at-once")}));
    ASSERT_EQ(at_once.status, 0) << at_once.errors;
    EXPECT_THAT(files_in("at-once"),
                testing::ElementsAre("milk_0005.png", "milk_0010.png", "milk_0015.png"));
    const files::GreyImage picture = files::read_grey_image(path("at-once/milk_0010.png"));
    EXPECT_EQ(picture.width, 24);
    EXPECT_EQ(picture.height, 18);
    ASSERT_EQ(tea({"--cache", path("kept")}).status, 0);
    ASSERT_EQ(run_cli(with({"tea", "render", path("kept"), "--range", "6-15", "--frames", path("later"),
                            "-q"}))
                  .status,
              0);
    EXPECT_THAT(files_in("later"), testing::ElementsAre("milk_0010.png", "milk_0015.png"));
    EXPECT_EQ(bytes("later/milk_0010.png"), bytes("at-once/milk_0010.png"));
    EXPECT_EQ(bytes("later/milk_0015.png"), bytes("at-once/milk_0015.png"));
    for (const char* range : {"0-3", "9-16", "7-5", "x", "3-"})
        expect_refusal({"tea", "render", path("kept"), "--range", range, "--frames", path("later")}, 2,
                       "is not FIRST-LAST, of frames 1 to 15.");
}

TEST_F(CliTea, ASequenceGoesOnWithWhatIsMissing) {
    ASSERT_EQ(tea({"--cache", path("kept")}).status, 0);
    fs::remove(path("kept/frame_000007.tea"));
    std::ofstream(path("kept/frame_000009.tea"), std::ios::binary) << "half";
    const fs::file_time_type before = fs::last_write_time(path("kept/frame_000008.tea"));
    ASSERT_EQ(tea({"--cache", path("kept")}).status, 0);
    EXPECT_TRUE(fs::exists(path("kept/frame_000007.tea")));
    EXPECT_GT(fs::file_size(path("kept/frame_000009.tea")), 1000U);
    EXPECT_EQ(fs::last_write_time(path("kept/frame_000008.tea")), before);
}

TEST_F(CliTea, AnotherTeaNeedsAnotherFolder) {
    ASSERT_EQ(tea({"--cache", path("kept")}).status, 0);
    const RunResult other = tea({"--cache", path("kept"), "--seed", "8"});
    EXPECT_EQ(other.status, 1);
    EXPECT_THAT(other.errors, HasSubstr("keeps frames of other tea"));
}

TEST_F(CliTea, AFullDiskLeavesWhatIsFinishedAndTheNextRunGoesOn) {
    // The later frames, with more milk in them, are larger.
    const std::vector<std::string> command = {"tea",       "--grid", "16", "--parcels", "12000",
                                              "--seconds", "1",      "-q", "--cache",   path("kept")};
    const RunResult full = run_cli_on_full_disk(64, command);
    EXPECT_EQ(full.status, 1);
    EXPECT_THAT(full.errors, AllOf(HasSubstr("kept/frame_0000"), HasSubstr("cannot be written")));
    const std::vector<std::string> finished = files_in("kept");
    ASSERT_GT(finished.size(), 2U);
    ASSERT_LT(finished.size(), 30U);
    const fs::file_time_type before = fs::last_write_time(path("kept/frame_000001.tea"));
    ASSERT_EQ(run_cli(command).status, 0);
    EXPECT_EQ(files_in("kept").size(), 32U);
    EXPECT_EQ(fs::last_write_time(path("kept/frame_000001.tea")), before);
}

TEST_F(CliTea, AnInterruptedSequenceKeepsWholeFiles) {
    const RunResult run = interrupt_program(
        "pastoso-cli", {"tea", "--grid", "16", "--seconds", "1000", "-q", "--cache", path("kept")},
        path("kept/frame_000005.tea"));
    EXPECT_EQ(run.status, 130);
    EXPECT_TRUE(fs::exists(path("kept/frame_000005.tea")));
    for (const std::string& name : files_in("kept"))
        EXPECT_TRUE(name == "tea.json" || name == "checkpoint.tea" ||
                    (name.starts_with("frame_") && name.ends_with(".tea")))
            << name;
}

TEST_F(CliTea, TheSystemOf2010PilesUpAndTodaysSolverDoesNot) {
    ASSERT_EQ(run_cli({"tea", "--classic", "--seconds", "2", "-q", "--stats", path("then.json"),
                       "--frames", path("then"), "--format", "pbrt", "--every", "60"})
                  .status,
              0);
    ASSERT_EQ(run_cli({"tea", "--classic", "--grid", "32", "--seconds", "2", "-q", "--stats",
                       path("now.json")})
                  .status,
              0);
    EXPECT_THAT(files_in("then"), testing::ElementsAre("milk_0060.pbrt"));
    EXPECT_EQ(json("then.json").at("parcels"), 1000);
    // 4.6 particles a voxel; spread by chance 1, give or take 0.1.
    EXPECT_GT(json("then.json").at("pile_up_dispersion").get<double>(), 3.0);
    EXPECT_LT(json("now.json").at("pile_up_dispersion").get<double>(), 1.3);
}

TEST_F(CliTea, BadInputIsRefusedInOneSentence) {
    expect_refusal({"tea"}, 2, "give --frames, --cache or --stats");
    expect_refusal({"tea", "--grid", "0", "--frames", path("out")}, 2, "--grid");
    expect_refusal({"tea", "--grid", "4096", "--frames", path("out")}, 2, "--grid");
    expect_refusal({"tea", "--size", "0x5", "--frames", path("out")}, 2, "--size: \"0x5\"");
    expect_refusal({"tea", "--format", "gif", "--frames", path("out")}, 2, "--format");
    expect_refusal({"tea", path("none.json"), "--frames", path("out")}, 1, "none.json");
    expect_refusal({"tea", "--classic", "--cache", path("out")}, 2, "cannot be kept in a cache");
    expect_refusal({"tea", "--classic", "--frames", path("out")}, 2, "give --format pbrt");
    expect_refusal({"tea", "render", path("none"), "--frames", path("out")}, 1, "none");
}

TEST_F(CliTea, ScenesThatComeWithTheProgramAreGivenByName) {
    ASSERT_EQ(tea({"--stats", path("plain.json")}).status, 0);
    ASSERT_EQ(tea({"usual", "--stats", path("usual.json")}).status, 0);
    ASSERT_EQ(tea({"cold-brew", "--stats", path("cold-brew.json")}).status, 0);
    EXPECT_EQ(json("usual.json").at("state_hash"), json("plain.json").at("state_hash"));
    EXPECT_NE(json("cold-brew.json").at("state_hash"), json("plain.json").at("state_hash"));
    EXPECT_THAT(run_cli({"tea", "--help"}).output,
                HasSubstr("cloud, cold-brew, cream, drops, stirred, usual."));
    expect_refusal({"tea", "earl-grey", "--cache", path("kept")}, 1, "There is no scene \"earl-grey\"");
}

TEST_F(CliTea, WhatIsKeptIsNotSimulatedAgain) {
    ASSERT_EQ(tea({"--cache", path("kept")}).status, 0);
    const RunResult again =
        run_cli({"tea", "--grid", "16", "--seconds", "0.5", "--cache", path("kept")});
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_THAT(again.errors, testing::Not(HasSubstr("pouring")));
    fs::remove(path("kept/frame_000007.tea"));
    EXPECT_THAT(run_cli({"tea", "--grid", "16", "--seconds", "0.5", "--cache", path("kept")}).errors,
                HasSubstr("pouring"));
}

TEST_F(CliTea, SceneFilesAreChecked) {
    const std::string scene =
        write("bad.json", R"({"format": "pastoso-tea", "version": 1, "viscosity_m2_s": -1})");
    const RunResult run = run_cli({"tea", scene, "--frames", path("out")});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.errors, AllOf(HasSubstr("bad.json"), HasSubstr("viscosity_m2_s is -1")));
    EXPECT_FALSE(fs::exists(path("out")));
}

}  // namespace
}  // namespace pastoso::cli
