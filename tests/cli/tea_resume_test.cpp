// A tea that was stopped goes on where it was, and becomes what it would have become.
#include "cli/liquid_test.hpp"

#include <algorithm>
#include <csignal>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

constexpr int kFrames = 90;

class CliTeaResume : public LiquidTest {
  protected:
    /// Three seconds of tea on a coarse grid, unless told otherwise: all milk is poured, and stirred.
    static std::vector<std::string> tea(const std::vector<std::string>& more,
                                        const std::string& seconds = "3") {
        std::vector<std::string> all = {"tea", "--grid", "20", "--seconds", seconds, "-q"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    std::string scene() const {
        return write("scene.json",
                     R"({"format": "pastoso-tea", "version": 1, "parcels": 1500, "first_ball_s": 0.5,
                         "ball_interval_s": 0.1, "confinement": 0.1, "advection": "reflected",
                         "swirl_rad_s2": 2})");
    }
    static std::string frame(const std::string& cache, int number) {
        char name[32];
        std::snprintf(name, sizeof name, "/frame_%06d.tea", number);
        return cache + name;
    }
    int frames_in(const std::string& cache) const {
        // Not the checkpoint, and what was half-written begins with a dot.
        const std::vector<fs::path> files = core::files_in(path(cache), ".tea");
        return static_cast<int>(std::ranges::count_if(
            files, [](const fs::path& file) { return file.filename().string().starts_with("frame_"); }));
    }
    void expect_same_frames(const std::string& cache, const std::string& other,
                            int frames = kFrames) const {
        for (int number = 1; number <= frames; ++number)
            EXPECT_EQ(bytes(frame(cache, number)), bytes(frame(other, number))) << number;
    }
    /// All of it in one go.
    void keep_whole(const std::string& cache, const std::string& seconds = "3") const {
        const RunResult run =
            run_cli(tea({scene(), "--cache", path(cache), "--stats", path(cache + ".json")}, seconds));
        ASSERT_EQ(run.status, 0) << run.errors;
    }
    static std::string seconds_of(int frames) { return std::to_string(frames / 30.0); }
};

TEST_F(CliTeaResume, AfterCtrlCItGoesOnToTheSameBits) {
    // So long that it is always stopped on its way, however late the signal comes; from there, half a
    // second more.
    const RunResult stopped = interrupt_program(
        "pastoso-cli", tea({scene(), "--cache", path("kept")}, "3600"), path(frame("kept", 20)));
    ASSERT_EQ(stopped.status, 130);
    const int done = frames_in("kept"), frames = done + 15;
    ASSERT_TRUE(fs::exists(path("kept/checkpoint.tea")));
    keep_whole("whole", seconds_of(frames));
    const RunResult again =
        run_cli(tea({scene(), "--cache", path("kept"), "--stats", path("kept.json"), "--threads", "1"},
                    seconds_of(frames)));
    ASSERT_EQ(again.status, 0) << again.errors;
    EXPECT_EQ(again.errors, "");
    EXPECT_EQ(json("kept.json").at("steps"), 15);
    EXPECT_EQ(json("kept.json").at("state_hash"), json("whole.json").at("state_hash"));
    EXPECT_EQ(json("kept.json").at("balls"), json("whole.json").at("balls"));
    expect_same_frames("kept", "whole", frames);
    EXPECT_EQ(bytes("kept/checkpoint.tea"), bytes("whole/checkpoint.tea"));
}

TEST_F(CliTeaResume, AKilledTeaGoesOnFromItsLastCheckpoint) {
    const RunResult killed = interrupt_program(
        "pastoso-cli", tea({scene(), "--cache", path("kept"), "--checkpoint", "0"}, "3600"),
        path(frame("kept", 10)), SIGKILL);
    ASSERT_EQ(killed.status, 128 + SIGKILL);
    const int frames = frames_in("kept") + 15;
    keep_whole("whole", seconds_of(frames));
    // What it was writing is left aside.
    const RunResult again = run_cli(
        tea({scene(), "--cache", path("kept"), "--stats", path("kept.json")}, seconds_of(frames)));
    ASSERT_EQ(again.status, 0) << again.errors;
    EXPECT_LE(json("kept.json").at("steps").get<int>(), frames - 9);
    expect_same_frames("kept", "whole", frames);
}

TEST_F(CliTeaResume, ADamagedOrForeignCheckpointIsToldAndTheTeaBeginsAnew) {
    ASSERT_EQ(run_cli(tea({"--cache", path("other")}, "0.2")).status, 0);
    keep_whole("whole");
    const auto after = [&](const std::string& checkpoint) {
        fs::remove_all(path("kept"));
        EXPECT_EQ(run_cli(tea({scene(), "--cache", path("kept")}, "0.5")).status, 0);
        write("kept/checkpoint.tea", checkpoint);
        const RunResult run =
            run_cli(tea({scene(), "--cache", path("kept"), "--stats", path("kept.json")}));
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(json("kept.json").at("steps"), kFrames);
        expect_same_frames("kept", "whole");
        return run.errors;
    };
    std::string damaged = bytes("whole/checkpoint.tea");
    damaged[damaged.size() / 2] ^= 1;
    EXPECT_THAT(after(damaged), AllOf(HasSubstr("checkpoint.tea: is damaged"),
                                      HasSubstr("The tea begins from the start.\n")));
    EXPECT_THAT(after(bytes("other/checkpoint.tea")),
                HasSubstr("checkpoint.tea: belongs to another scene. The tea begins from the start.\n"));
}

TEST_F(CliTeaResume, AFrameThatIsMissingBeforeTheCheckpointIsPouredAgain) {
    keep_whole("whole");
    const std::string lost = bytes(frame("whole", 7));
    fs::remove(path(frame("whole", 7)));
    ASSERT_EQ(run_cli(tea({scene(), "--cache", path("whole"), "--stats", path("again.json")})).status,
              0);
    EXPECT_EQ(json("again.json").at("steps"), kFrames);
    EXPECT_EQ(bytes(frame("whole", 7)), lost);
}

TEST_F(CliTeaResume, ALongerTeaGoesOnFromTheEndAndDrawsWhatWasKept) {
    const std::vector<std::string> files = {"--frames", path("files"), "--format",
                                            "stl",      "--every",     "30"};
    ASSERT_EQ(
        run_cli(tea({scene(), "--frames", path("at-once"), "--format", "stl", "--every", "30"})).status,
        0);
    ASSERT_EQ(run_cli(tea({scene(), "--cache", path("kept")}, "1.5")).status, 0);
    std::vector<std::string> longer = {scene(), "--cache", path("kept"), "--stats", path("kept.json")};
    longer.insert(longer.end(), files.begin(), files.end());
    ASSERT_EQ(run_cli(tea(longer)).status, 0);
    EXPECT_EQ(json("kept.json").at("steps"), kFrames / 2);
    EXPECT_EQ(json("kept.json").at("frames"), 3);
    for (const char* name : {"/milk_0030.stl", "/milk_0060.stl", "/milk_0090.stl"})
        EXPECT_EQ(bytes(std::string("files") + name), bytes(std::string("at-once") + name)) << name;
}

}  // namespace
}  // namespace pastoso::cli
