// Signals that come while a file is being written, at the moment when it has been created, aside.
#include "cli/liquid_test.hpp"
#include "document/well_session.hpp"
#include "files/image.hpp"
#include "journal/journals.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PASTOSO_SKIP_PRELOADED() \
    GTEST_SKIP() << "a sanitizer allows no library to be loaded before its own"
#else
#define PASTOSO_SKIP_PRELOADED()
#endif

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

using Arguments = std::vector<std::string>;

class CliSignals : public LiquidTest {
  protected:
    /// Runs pastoso-cli and sends it the signal when it has created so many files of such a name.
    RunResult run_until(const std::string& file, int count, int signal,
                        const Arguments& arguments) const {
        Arguments all = {"LD_PRELOAD=" PASTOSO_SIGNAL_SHIM, "PASTOSO_SIGNAL_FILE=" + file,
                         "PASTOSO_SIGNAL_COUNT=" + std::to_string(count),
                         "PASTOSO_SIGNAL=" + std::to_string(signal),
                         (core::program_folder() / "pastoso-cli").string()};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return run_program("/usr/bin/env", all);
    }

    /// Part files are hidden ones.
    int hidden_files() const {
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            count += entry.path().filename().string().starts_with('.') ? 1 : 0;
        return count;
    }

    /// Whether the signal came before the command, which makes `made`, had ended.
    bool is_stopped(const std::string& file, int count, int signal, const std::string& made,
                    const Arguments& arguments) const {
        fs::remove_all(path(made));
        const RunResult run = run_until(file, count, signal, arguments);
        EXPECT_EQ(hidden_files(), 0) << arguments[0] << ", signal " << signal;
        if (run.status == 0) return false;
        EXPECT_EQ(run.status, 128 + signal) << arguments[0] << ": " << run.errors;
        EXPECT_THAT(run.errors, EndsWith("pastoso-cli: stopped.\n")) << arguments[0];
        return true;
    }

    /// Every signal stops the command whenever it has created a file of that name: it may be a trial,
    /// whether the place can be written to at all.
    void expect_orderly_end(const std::string& file, const std::string& made,
                            const Arguments& arguments) const {
        constexpr int kMostTimes = 3;
        int times = 0;
        while (times < kMostTimes && is_stopped(file, times + 1, SIGINT, made, arguments))
            ++times;
        EXPECT_GT(times, 0) << arguments[0] << " never creates " << file;
        for (const int signal : {SIGTERM, SIGHUP})
            EXPECT_TRUE(is_stopped(file, times, signal, made, arguments)) << arguments[0];
    }
    /// The same of work that is given up at once.
    void expect_given_up(const std::string& file, const std::string& made,
                         const Arguments& arguments) const {
        expect_orderly_end(file, made, arguments);
        EXPECT_FALSE(fs::exists(path(made))) << arguments[0];
    }

    std::string project() const {
        const std::string file = path("it.pastoso");
        EXPECT_EQ(run_cli(small({"replay", short_recording(), "--save", file, "-q"})).status, 0);
        return file;
    }
    std::string picture() const {
        core::write_text_file(path("a.png"),
                              files::png_file(pigment::Picture{2, 1, {9, 9, 9, 255, 200, 9, 9, 255}}));
        return path("a.png");
    }
    std::string dam() const {
        return write("dam.json",
                     R"({"format": "pastoso-tank", "version": 1, "cells": [8, 8, 8], "cell_m": 0.125,
                         "liquids": [{"shape": {"block": {"low_m": [-1, -1, -1], "high_m": [0.5, 2, 0.5]}}}]})");
    }
    /// Few pixels.
    static Arguments frames(Arguments arguments) {
        for (const char* word : {"-q", "--size", "20x15", "--samples", "2"})
            arguments.emplace_back(word);
        return arguments;
    }
    Arguments tea(const Arguments& more) const {
        // Three frames: enough to be stopped among them.
        Arguments all = {"tea", "--grid", "16", "--seconds", "0.1"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(CliSignals, StopReplays) {
    PASTOSO_SKIP_PRELOADED();
    const std::string pen = short_recording();
    expect_orderly_end("out", "out.png", small({"replay", pen, "-o", path("out.png"), "-q"}));
    expect_orderly_end("well", "well.png", small({"replay", pen, "--well", path("well.png"), "-q"}));
    expect_orderly_end("out", "out.pastoso",
                       small({"replay", pen, "--save", path("out.pastoso"), "-q"}));
    expect_orderly_end("stats", "stats.json",
                       small({"replay", pen, "--stats", path("stats.json"), "-q"}));
    expect_orderly_end("frame-00002", "frames",
                       small({"replay", pen, "--frames", path("frames"), "--fps", "30", "-q"}));
    EXPECT_TRUE(fs::exists(path("frames/frame-00001.png")));
    // A replay like any other, of a recording that takes long.
    EXPECT_TRUE(is_stopped("sheet", 1, SIGHUP, "sheet.png", {"sheet", "-o", path("sheet.png"), "-q"}));
}

TEST_F(CliSignals, StopExports) {
    PASTOSO_SKIP_PRELOADED();
    const std::string painting = project();
    expect_given_up("out", "out.png", {"export", painting, "-o", path("out.png"), "-q"});
    expect_given_up("out", "out.exr", {"export", painting, "-o", path("out.exr"), "--layers", "-q"});
    expect_given_up("well", "well.tif", {"export", painting, "--well", path("well.tif"), "-q"});
    expect_given_up("out", "out.stl", {"export", painting, "-o", path("out.stl"), "-q"});
    expect_given_up("out", "out.png", {"convert", painting, path("out.png"), "-q"});
    expect_orderly_end("maps", "none", {"export", painting, "-o", path("maps.png"), "--maps", "-q"});
}

TEST_F(CliSignals, StopConversionsAndTimelapses) {
    PASTOSO_SKIP_PRELOADED();
    expect_orderly_end("made", "made.pastoso",
                       {"convert", picture(), path("made.pastoso"), "--px-per-mm", "0.5"});
    const std::string painting = project();
    expect_orderly_end("0002", "frames", {"timelapse", painting, "-o", path("frames"), "-q"});
    expect_given_up("film", "film.mkv", {"timelapse", painting, "-o", path("film.mkv"), "-q"});
}

TEST_F(CliSignals, StopRecovery) {
    PASTOSO_SKIP_PRELOADED();
    ::setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
    core::ThreadPool pool(1);
    journal::left_behind(journal::journals_path(), document::mixing_session(), {}, pool);
    // As a trial, and when it is saved: a run that came to its end would forget the painting.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        for (const int count : {1, 2})
            EXPECT_TRUE(is_stopped("made", count, signal, "made.pastoso",
                                   {"recover", "-o", path("made.pastoso"), "-q"}));
    EXPECT_NE(run_cli({"recover", "--list"}).output, "") << "what was stopped is not forgotten";
    ::unsetenv("XDG_STATE_HOME");
}

TEST_F(CliSignals, StopSimulations) {
    PASTOSO_SKIP_PRELOADED();
    const std::string scene = write("a.json", R"({"format": "pastoso-scene", "version": 1,
        "size_mm": [20, 10], "cell_mm": 0.5, "paint": "house paint", "duration_s": 0.1,
        "film": [{"kind": "cap", "at_mm": [5, 5], "radius_mm": 3, "thickness_mm": 1, "pigment": "PB29"}]})");
    for (const std::string file : {"png", "csv", "report"})
        expect_orderly_end(file, "out", {"simulate", scene, "-o", path("out"), "-q"});
}

TEST_F(CliSignals, StopTeas) {
    PASTOSO_SKIP_PRELOADED();
    // Photons make a picture of tea dear, so at the first of three; meshes are stopped at a later one.
    expect_orderly_end("milk_0001", "out", frames(tea({"--frames", path("out")})));
    expect_orderly_end("milk_0002", "out", tea({"--frames", path("out"), "--format", "obj", "-q"}));
    expect_orderly_end("0002", "out", tea({"--cache", path("out"), "-q"}));
    expect_orderly_end("stats", "stats.json", tea({"--stats", path("stats.json"), "-q"}));
    expect_orderly_end("milk_0002", "out",
                       tea({"--classic", "--frames", path("out"), "--format", "ply", "-q"}));
    ASSERT_EQ(run_cli(tea({"--cache", path("kept"), "-q"})).status, 0);
    expect_orderly_end("milk_0001", "out",
                       frames({"tea", "render", path("kept"), "--frames", path("out")}));
}

TEST_F(CliSignals, StopTanks) {
    PASTOSO_SKIP_PRELOADED();
    const Arguments tank = {"tank", dam(), "--seconds", "0.1", "--frames", path("out")};
    expect_orderly_end("liquid_0002", "out", frames(tank));
    EXPECT_TRUE(fs::exists(path("out/checkpoint.tank"))) << "what the next run goes on from";
    for (const std::string file : {"tank", "series", "liquid_0002", "checkpoint"}) {
        Arguments meshes = tank;
        meshes.insert(meshes.end(), {"--format", "stl", "-q"});
        expect_orderly_end(file, "out", meshes);
    }
}

/// A run that was started with nohup outlives its terminal.
TEST_F(CliSignals, WhatIsIgnoredAlreadyStaysIgnored) {
    PASTOSO_SKIP_PRELOADED();
    ::signal(SIGHUP, SIG_IGN);
    const RunResult run =
        run_until("out", 1, SIGHUP, small({"replay", short_recording(), "-o", path("out.png"), "-q"}));
    ::signal(SIGHUP, SIG_DFL);
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_TRUE(fs::exists(path("out.png")));
}

TEST_F(CliSignals, AFileThatMayNotGrowIsToldInASentence) {
    const std::string pen = short_recording(), source = picture();
    for (const Arguments& command :
         {small({"replay", pen, "--save", path("out.pastoso"), "-q"}),
          Arguments{"convert", source, path("out.pastoso"), "--px-per-mm", "0.5"},
          tea({"--cache", path("out"), "-q"})}) {
        const RunResult run = run_cli_on_full_disk(1, command);
        EXPECT_EQ(run.status, 1) << command[0];
        EXPECT_THAT(run.errors, StartsWith("pastoso-cli: " + folder.string())) << command[0];
        EXPECT_THAT(run.errors, HasSubstr("cannot be written (")) << command[0];
        EXPECT_EQ(hidden_files(), 0) << command[0];
    }
}

/// pastoso-cli whose output is a pipe that nobody reads any more.
RunResult run_into_closed_pipe(const Arguments& arguments) {
    Arguments all = {"-c", "exec > >(exec true); wait $!; exec \"$@\"", "bash",
                     (core::program_folder() / "pastoso-cli").string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program("/bin/bash", all);
}

TEST_F(CliSignals, OutputThatNobodyReadsIsAnError) {
    for (const Arguments& command :
         {Arguments{"info", "paints"}, Arguments{"info"}, Arguments{"--help"},
          small({"replay", short_recording(), "-o", path("out.png"), "-q"})}) {
        const RunResult run = run_into_closed_pipe(command);
        EXPECT_EQ(run.status, 1) << command[0];
        EXPECT_EQ(run.errors, "pastoso-cli: the standard output: cannot be written (Broken pipe).\n")
            << command[0];
    }
    EXPECT_TRUE(fs::exists(path("out.png")));
}

}  // namespace
}  // namespace pastoso::cli
