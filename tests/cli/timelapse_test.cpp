#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CliTimelapse : public CliTest {
  protected:
    ~CliTimelapse() override { ::setenv("PATH", search_path.c_str(), 1); }

    /// A JSON recording of a short stroke: 0.2 s, and some time to run.
    std::string recording() const {
        const RunResult run =
            run_cli(small({"replay", "-q", short_recording(), "--save", path("a.pastoso")}));
        EXPECT_EQ(run.status, 0) << run.errors;
        return path("a.pastoso");
    }

    RunResult frames(const std::string& source, const std::string& folder_name,
                     const std::string& speed = "1") const {
        return run_cli(
            {"timelapse", "-q", source, "-o", path(folder_name), "--fps", "10", "--speed", speed});
    }

    std::string file(const std::string& name) const { return core::read_text_file(path(name)); }

    /// A program that answers to the name of ffmpeg: keeps its arguments and its input.
    void install_ffmpeg(const std::string& script) {
        std::filesystem::create_directory(path("bin"));
        write("bin/ffmpeg", "#!/bin/sh\n" + script);
        std::filesystem::permissions(path("bin/ffmpeg"), std::filesystem::perms::owner_all);
        ::setenv("PATH", (path("bin") + ":" + search_path).c_str(), 1);
    }

    std::string search_path = std::getenv("PATH");
};

TEST_F(CliTimelapse, FramesShowThePaintingAtEvenTimesAndItsEnd) {
    const std::string painting = recording();
    const RunResult run = frames(painting, "frames");
    ASSERT_EQ(run.status, 0) << run.errors;
    // Of 0.2 s of strokes and 0.1 s after: at 0, 0.1, 0.2 s and at the end.
    EXPECT_THAT(run.output, StartsWith(path("frames") + ": 4 frames, 4 of them new\n"));
    ASSERT_EQ(run_cli({"export", "-q", painting, "-o", path("end.png")}).status, 0);
    EXPECT_EQ(file("frames/frame-00004.png"), file("end.png"));
    EXPECT_NE(file("frames/frame-00001.png"), file("end.png"));
    EXPECT_FALSE(std::filesystem::exists(path("frames/frame-00005.png")));
}

TEST_F(CliTimelapse, WhatIsMissingIsMadeAgainTheSame) {
    const std::string painting = recording();
    ASSERT_EQ(frames(painting, "frames").status, 0);
    const std::string second = file("frames/frame-00002.png"), third = file("frames/frame-00003.png");
    std::filesystem::remove(path("frames/frame-00002.png"));
    write("frames/frame-00003.png", "kept");
    const RunResult run = frames(painting, "frames");
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr(": 4 frames, 1 of them new\n"));
    EXPECT_EQ(file("frames/frame-00002.png"), second);
    EXPECT_EQ(file("frames/frame-00003.png"), "kept");
}

TEST_F(CliTimelapse, FramesOfAnotherOneAreLeftAlone) {
    const std::string painting = recording();
    ASSERT_EQ(frames(painting, "frames").status, 0);
    const RunResult run = frames(painting, "frames", "2");
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.errors, "pastoso-cli: " + path("frames") +
                              ": holds frames of another time-lapse; name another folder, or remove "
                              "them.\n");
}

TEST_F(CliTimelapse, ACanvasThatGrowsIsFittedIntoTheFirstFrame) {
    write(
        "growing.json",
        R"({"format":"pastoso-strokes","version":6,"canvas":{"width_mm":20,"height_mm":10,"px_per_mm":4},)"
        R"("end_tick":12,"events":[{"tick":6,"resize_canvas":{"width_mm":20,"height_mm":20}}]})");
    ASSERT_EQ(frames(path("growing.json"), "frames").status, 0);
    for (const char* name : {"frames/frame-00001.png", "frames/frame-00003.png"}) {
        const files::GreyImage frame = files::read_grey_image(path(name));
        EXPECT_EQ(frame.width, 80);
        EXPECT_EQ(frame.height, 40);
    }
    const files::GreyImage last = files::read_grey_image(path("frames/frame-00003.png"));
    const auto at = [&](int x, int y) { return last.values[static_cast<std::size_t>(80 * y + x)]; };
    EXPECT_NEAR(at(5, 20), 118.0 / 255.0, 0.01) << "middle grey of sRGB beside a square canvas";
    EXPECT_NEAR(at(75, 20), at(5, 20), 1e-6);
    EXPECT_GT(at(40, 20), 0.7) << "primed linen";
    EXPECT_GT(at(22, 1), 0.7);
}

TEST_F(CliTimelapse, AVideoIsMadeByFfmpeg) {
    install_ffmpeg("echo \"$@\" > " + path("arguments") +
                   "\nfor last; do :; done\ncat > \"${last#file:}\"\n");
    const std::string painting = recording();
    const RunResult run =
        run_cli({"timelapse", "-q", painting, "-o", path("film.mp4"), "--fps", "10", "--speed", "1"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.output, path("film.mp4") + ": 4 frames of 80 x 60 pixels\n");
    EXPECT_THAT(file("arguments"), HasSubstr("-pixel_format rgb24 -video_size 80x60 -framerate 10 "));
    // The stand-in keeps the frames as they come.
    const std::string film = file("film.mp4");
    ASSERT_EQ(film.size(), 4U * 80U * 60U * 3U);
    ASSERT_EQ(run_cli({"export", "-q", painting, "-o", path("end.png")}).status, 0);
    const files::GreyImage end = files::read_grey_image(path("end.png"));
    for (std::size_t i = 0; i < end.values.size(); ++i) {
        const auto* rgb =
            reinterpret_cast<const unsigned char*>(film.data()) + 3 * (3 * end.values.size() + i);
        // Weights of luminance in single precision.
        EXPECT_NEAR((0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 255.0, end.values[i], 1e-5);
    }
}

// Matroska files would hold a random number otherwise.
TEST_F(CliTimelapse, AVideoOfTheSamePaintingHasTheSameBytes) {
    const std::string painting = recording();
    for (const std::string ending : {".mp4", ".mkv", ".webm"}) {
        for (const char* name : {"first", "second"})
            ASSERT_EQ(run_cli({"timelapse", "-q", painting, "-o", path(name + ending)}).status, 0);
        EXPECT_GT(file("first" + ending).size(), 500U) << ending;
        EXPECT_TRUE(file("first" + ending) == file("second" + ending)) << ending;
    }
}

TEST_F(CliTimelapse, WhatFfmpegComplainsOfIsTold) {
    install_ffmpeg("echo no such codec >&2\nexit 1\n");
    const std::string painting = recording();
    const std::size_t files = files_in_folder();
    const RunResult run = run_cli({"timelapse", "-q", painting, "-o", path("film.mp4")});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.errors,
              "pastoso-cli: " + path("film.mp4") + ": ffmpeg cannot make the video (no such codec).\n");
    EXPECT_EQ(files_in_folder(), files);
}

TEST_F(CliTimelapse, WhatCannotBeDoneIsToldInASentence) {
    const std::string painting = recording();
    ::setenv("PATH", path("nowhere").c_str(), 1);
    expect_refusal({"timelapse", painting, "-o", path("a.mp4")}, 1,
                   path("a.mp4") +
                       ": a video is made by the program ffmpeg, which is not installed; a "
                       "folder's name instead gives numbered pictures.");
    expect_refusal({"timelapse", painting, "-o", path("a.gif")}, 1,
                   path("a.gif") + ": a video is saved as .mp4, .mkv or .webm");
    expect_refusal({"timelapse", painting, "-o", path("a.mp4"), "--depth", "16"}, 2,
                   "--profile and --depth are for numbered pictures");
    expect_refusal({"timelapse", path("none.json"), "-o", path("frames")}, 1,
                   "none.json: cannot be opened (No such file or directory).");
    expect_refusal({"timelapse", painting}, 2, "--output");
}

}  // namespace
}  // namespace pastoso::cli
