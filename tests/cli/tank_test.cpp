#include "cli/liquid_test.hpp"
#include "files/image.hpp"

#include <cmath>
#include <csignal>
#include <fstream>
#include <map>
#include <sstream>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// The edges of the first frame's block of six cells are rounded where its surface is evened out: a
/// fifth of a cell all around would be 0.1. Measured 0.056.
constexpr double kVolumeError = 0.08;
constexpr int kFrames = 15;

/// Of a run that is stopped on its way, however late the signal comes.
constexpr const char* kEndless_s = "3600";

/// Columns of a table of numbers, by their names.
using Series = std::map<std::string, std::vector<double>>;

class CliTank : public LiquidTest {
  protected:
    /// A dam of 1/4 m3 that breaks in a tank of a cubic metre, and a little solid.
    std::string scene() const {
        return write("dam.json",
                     R"({"format": "pastoso-tank", "version": 1, "cells": [12, 12, 12],
                         "cell_m": 0.08333333333,
                         "liquids": [{"shape": {"block": {"low_m": [-1, -1, -1], "high_m": [0.5, 2, 0.5]}},
                                      "milk": 0.1}],
                         "solids": [{"sphere": {"centre_m": [0.75, 0.5, 0], "radius_m": 0.15}}]})");
    }
    /// Half a second of it, unless told otherwise.
    std::vector<std::string> tank(const std::vector<std::string>& more,
                                  const std::string& seconds = "0.5") const {
        std::vector<std::string> all = {"tank", scene(), "--seconds", seconds, "-q"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Series series(const std::string& name) const {
        std::istringstream text(bytes(name));
        std::string line, field;
        std::vector<std::string> names;
        Series found;
        std::getline(text, line);
        for (std::istringstream heading(line); std::getline(heading, field, ',');)
            names.push_back(field);
        while (std::getline(text, line)) {
            std::istringstream numbers(line);
            for (const std::string& column : names) {
                std::getline(numbers, field, ',');
                found[column].push_back(std::stod(field));
            }
        }
        return found;
    }
    /// So many seconds are half of one after the last surface in that folder.
    std::string half_a_second_after(const std::string& name) const {
        int last = 0;
        for (const std::string& file : files_in(name)) {
            int frame = 0;
            if (std::sscanf(file.c_str(), "liquid_%d.stl", &frame) == 1) last = std::max(last, frame);
        }
        return std::to_string((last + kFrames) / 30.0);
    }
    /// All but what depends on the machine's speed.
    void expect_same_series(const std::string& name, const std::string& other) const {
        Series one = series(name), two = series(other);
        one.erase("step_s");
        two.erase("step_s");
        EXPECT_EQ(one, two);
    }
};

TEST_F(CliTank, WritesMeshesAndWhatWasMeasured) {
    const RunResult run = run_cli(tank({"--frames", path("out"), "--format", "obj", "--every", "5"}));
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
    EXPECT_THAT(files_in("out"), ElementsAre("checkpoint.tank", "liquid_0005.obj", "liquid_0010.obj",
                                             "liquid_0015.obj", "series.csv", "tank.json"));
    EXPECT_THAT(bytes("out/liquid_0005.obj"), HasSubstr("liquid"));
    const Series rows = series("out/series.csv");
    ASSERT_EQ(rows.at("time_s").size(), std::size_t{kFrames} + 1);
    for (int frame = 0; frame <= kFrames; ++frame)
        EXPECT_NEAR(rows.at("time_s")[static_cast<std::size_t>(frame)], frame / 30.0, 1e-6);
    // Measured 0.253: the level around particles is rough.
    EXPECT_NEAR(rows.at("volume_m3").front(), 0.25, 0.006);
    EXPECT_NEAR(rows.at("front_x_m").front(), 0.5, 0.05);
    // It falls freely at most: 0.5 g t^2 against the 0.5 m to the other wall.
    EXPECT_GT(rows.at("front_x_m").back(), 0.8);
    EXPECT_LE(rows.at("front_x_m").back(), 1.0);
    EXPECT_EQ(rows.at("volume_error_rel").front(), 0.0);
    for (const double error : rows.at("volume_error_rel"))
        EXPECT_LT(std::abs(error), kVolumeError);
    EXPECT_GT(rows.at("fastest_m_s").back(), 0.5);
    EXPECT_LT(rows.at("fastest_m_s").back(), 10.0);
    EXPECT_GT(rows.at("steps").back(), kFrames - 1.0);
    EXPECT_GT(rows.at("pressure_iterations").back(), 0.0);
}

TEST_F(CliTank, StatsTellWhatHappened) {
    ASSERT_EQ(run_cli(tank({"--stats", path("stats.json"), "--threads", "1"})).status, 0);
    const files::Json stats = json("stats.json");
    EXPECT_EQ(stats.at("cells"), 12 * 12 * 12);
    EXPECT_EQ(stats.at("frames"), 0);
    EXPECT_EQ(stats.at("threads"), 1);
    EXPECT_NEAR(stats.at("seconds").get<double>(), 0.5, 1e-6);
    EXPECT_GE(stats.at("steps").get<int>(), kFrames);
    EXPECT_GT(stats.at("steps_per_s").get<double>(), 0.0);
    // Eight in each of 6 x 12 x 6 cells.
    EXPECT_EQ(stats.at("particles"), 8 * 6 * 12 * 6);
    EXPECT_LT(std::abs(stats.at("volume_error_rel").get<double>()), kVolumeError);
    EXPECT_GE(stats.at("volume_error_rel_max").get<double>(),
              std::abs(stats.at("volume_error_rel").get<double>()));
    EXPECT_GT(stats.at("front_x_m").get<double>(), 0.8);
    EXPECT_EQ(stats.at("not_converged"), 0);
}

TEST_F(CliTank, EveryFormatIsWritten) {
    for (const std::string format : {"ply", "stl", "pbrt"}) {
        const RunResult run =
            run_cli(tank({"--frames", path(format), "--every", "3", "--format", format}, "0.1"));
        ASSERT_EQ(run.status, 0) << run.errors;
        EXPECT_GT(fs::file_size(path(format + "/liquid_0003." + format)), 1000U);
    }
    ASSERT_EQ(
        run_cli(
            tank({"--frames", path("png"), "--every", "3", "--size", "40x30", "--samples", "2"}, "0.1"))
            .status,
        0);
    const files::GreyImage picture = files::read_grey_image(path("png/liquid_0003.png"));
    EXPECT_EQ(picture.width, 40);
    EXPECT_EQ(picture.height, 30);
}

TEST_F(CliTank, EveryMethodRunsAndThreadsDoNotMatter) {
    std::vector<std::string> hashes;
    for (const std::string method :
         {"particles", "level_set", "upwind_level_set", "particle_level_set"}) {
        for (const std::string threads : {"1", "3"}) {
            const RunResult run = run_cli(tank(
                {"--method", method, "--threads", threads, "--stats", path(method + threads + ".json")},
                "0.2"));
            ASSERT_EQ(run.status, 0) << run.errors;
        }
        EXPECT_EQ(json(method + "1.json").at("state_hash"), json(method + "3.json").at("state_hash"));
        hashes.push_back(json(method + "1.json").at("state_hash").get<std::string>());
    }
    std::ranges::sort(hashes);
    EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

TEST_F(CliTank, AfterCtrlCItGoesOnToTheSameBits) {
    for (const std::string method : {"particles", "particle_level_set"}) {
        const auto run_into = [&](const std::string& into, const std::string& seconds) {
            return tank({"--method", method, "--frames", path(into), "--format", "stl", "--stats",
                         path(into + ".json")},
                        seconds);
        };
        const std::string whole = method + "-whole", kept = method + "-kept";
        const RunResult stopped = interrupt_program("pastoso-cli", run_into(kept, kEndless_s),
                                                    path(kept + "/liquid_0004.stl"));
        ASSERT_EQ(stopped.status, 130);
        ASSERT_TRUE(fs::exists(path(kept + "/checkpoint.tank")));
        const std::string seconds = half_a_second_after(kept);
        ASSERT_EQ(run_cli(run_into(whole, seconds)).status, 0);
        ASSERT_LT(files_in(kept).size(), files_in(whole).size());
        const RunResult again = run_cli(run_into(kept, seconds));
        ASSERT_EQ(again.status, 0) << again.errors;
        EXPECT_EQ(again.errors, "");
        EXPECT_LT(json(kept + ".json").at("steps").get<int>(),
                  json(whole + ".json").at("steps").get<int>());
        EXPECT_EQ(json(kept + ".json").at("state_hash"), json(whole + ".json").at("state_hash"));
        EXPECT_EQ(files_in(kept), files_in(whole));
        for (const std::string& name : files_in(whole)) {
            if (!name.ends_with(".stl")) continue;
            EXPECT_EQ(bytes(kept + "/" + name), bytes(whole + "/" + name)) << name;
        }
        expect_same_series(kept + "/series.csv", whole + "/series.csv");
    }
}

TEST_F(CliTank, AKilledTankGoesOnFromItsLastCheckpoint) {
    const auto run_into = [&](const std::string& into, const std::string& seconds) {
        return tank({"--frames", path(into), "--format", "stl", "--every", "5", "--checkpoint", "0",
                     "--stats", path(into + ".json")},
                    seconds);
    };
    ASSERT_EQ(interrupt_program("pastoso-cli", run_into("kept", kEndless_s),
                                path("kept/liquid_0010.stl"), SIGKILL)
                  .status,
              128 + SIGKILL);
    const std::string seconds = half_a_second_after("kept");
    ASSERT_EQ(run_cli(run_into("whole", seconds)).status, 0);
    ASSERT_EQ(run_cli(run_into("kept", seconds)).status, 0);
    EXPECT_LT(json("kept.json").at("steps").get<int>(), json("whole.json").at("steps").get<int>());
    EXPECT_EQ(json("kept.json").at("state_hash"), json("whole.json").at("state_hash"));
    expect_same_series("kept/series.csv", "whole/series.csv");
}

TEST_F(CliTank, ALongerRunGoesOnFromTheEndOfAShorterOne) {
    ASSERT_EQ(run_cli(tank({"--frames", path("out"), "--format", "stl", "--every", "15"})).status, 0);
    ASSERT_EQ(run_cli(tank({"--frames", path("out"), "--format", "stl", "--every", "15", "--stats",
                            path("longer.json")},
                           "1"))
                  .status,
              0);
    ASSERT_EQ(run_cli(tank({"--stats", path("whole.json")}, "1")).status, 0);
    EXPECT_LT(json("longer.json").at("steps").get<int>(), json("whole.json").at("steps").get<int>());
    EXPECT_EQ(json("longer.json").at("state_hash"), json("whole.json").at("state_hash"));
    EXPECT_EQ(json("longer.json").at("frames"), 1);
    // Files of another kind are missing: it begins anew, to the same.
    ASSERT_EQ(run_cli(tank({"--frames", path("out"), "--format", "ply", "--every", "15", "--stats",
                            path("anew.json")},
                           "1"))
                  .status,
              0);
    EXPECT_EQ(json("anew.json").at("steps"), json("whole.json").at("steps"));
    EXPECT_TRUE(fs::exists(path("out/liquid_0015.ply")));
}

TEST_F(CliTank, ADamagedCheckpointIsToldAndTheTankBeginsAnew) {
    ASSERT_EQ(run_cli(tank({"--frames", path("out"), "--format", "stl"}, "0.1")).status, 0);
    std::string damaged = bytes("out/checkpoint.tank");
    damaged[damaged.size() / 2] ^= 1;
    write("out/checkpoint.tank", damaged);
    const RunResult run =
        run_cli(tank({"--frames", path("out"), "--format", "stl", "--stats", path("stats.json")}));
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.errors, AllOf(HasSubstr("checkpoint.tank: is damaged"),
                                  HasSubstr("The tank begins from the start.\n")));
    EXPECT_EQ(series("out/series.csv").at("time_s").size(), std::size_t{kFrames} + 1);
}

TEST_F(CliTank, AnotherTankNeedsAnotherFolder) {
    ASSERT_EQ(run_cli(tank({"--frames", path("out"), "--format", "stl"}, "0.1")).status, 0);
    for (const std::vector<std::string>& other :
         {std::vector<std::string>{"--method", "level_set"}, {"--fps", "25"}}) {
        std::vector<std::string> arguments = tank({"--frames", path("out"), "--format", "stl"}, "0.1");
        arguments.insert(arguments.end(), other.begin(), other.end());
        expect_refusal(arguments, 1, "out: keeps frames of another tank; choose another folder.");
    }
}

TEST_F(CliTank, AFullDiskLeavesWhatIsFinishedAndTheNextRunGoesOn) {
    const std::vector<std::string> command =
        tank({"--frames", path("out"), "--format", "stl", "--stats", path("stats.json")});
    // The first mesh has 162 KiB, the last, with more spray, 274.
    const RunResult full = run_cli_on_full_disk(220, command);
    EXPECT_EQ(full.status, 1);
    EXPECT_THAT(full.errors, AllOf(HasSubstr("out/liquid_00"), HasSubstr("cannot be written")));
    for (const std::string& name : files_in("out"))
        EXPECT_THAT(name,
                    testing::AnyOf("tank.json", "series.csv",
                                   AllOf(testing::StartsWith("liquid_"), testing::EndsWith(".stl"))));
    const fs::file_time_type before = fs::last_write_time(path("out/liquid_0001.stl"));
    ASSERT_EQ(run_cli(command).status, 0);
    EXPECT_EQ(files_in("out").size(), std::size_t{kFrames} + 3);
    EXPECT_EQ(fs::last_write_time(path("out/liquid_0001.stl")), before);
}

TEST_F(CliTank, ScenesThatComeWithTheProgramAreGivenByName) {
    EXPECT_THAT(run_cli({"tank", "--help"}).output, HasSubstr("falling-liquid, two-liquids."));
    expect_refusal({"tank", "aquarium", "--stats", path("stats.json")}, 1,
                   "There is no scene \"aquarium\"");
    const RunResult run =
        run_cli({"tank", "falling-liquid", "--seconds", "0.034", "-q", "--stats", path("stats.json")});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(json("stats.json").at("cells"), 64 * 64 * 64);
}

TEST_F(CliTank, BadInputIsRefusedInOneSentence) {
    const std::string dam = scene();
    expect_refusal({"tank"}, 2, "SCENE");
    expect_refusal({"tank", dam}, 2, "give --frames or --stats");
    expect_refusal({"tank", dam, "--frames", path("out"), "--seconds", "0"}, 2, "less than one frame");
    expect_refusal({"tank", dam, "--frames", path("out"), "--seconds", "-1"}, 2, "--seconds");
    expect_refusal({"tank", dam, "--frames", path("out"), "--fps", "0"}, 2, "--fps");
    expect_refusal({"tank", dam, "--frames", path("out"), "--size", "0x5"}, 2, "--size: \"0x5\"");
    expect_refusal({"tank", dam, "--frames", path("out"), "--format", "gif"}, 2, "--format");
    expect_refusal({"tank", dam, "--frames", path("out"), "--method", "sph"}, 2, "--method");
    expect_refusal({"tank", path("none.json"), "--frames", path("out")}, 1, "none.json");
    const std::string bad =
        write("bad.json", R"({"format": "pastoso-tank", "version": 1, "courant": 9})");
    expect_refusal({"tank", bad, "--frames", path("out")}, 1, "courant is 9");
}

}  // namespace
}  // namespace pastoso::cli
