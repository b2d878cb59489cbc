#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "files/json_place.hpp"
#include "recordings/scene_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using files::Json;
using testing::HasSubstr;

class CliSimulate : public CliTest {
  protected:
    std::string text(const std::string& name) const { return core::read_text_file(path(name)); }

    /// The column of a table, by its heading.
    std::vector<double> column(const std::string& file, const std::string& heading) const {
        std::istringstream lines(text(file));
        std::string line;
        std::getline(lines, line);
        const std::string before = line.substr(0, line.find(heading));
        const auto index = std::count(before.begin(), before.end(), ',');
        std::vector<double> values;
        while (std::getline(lines, line)) {
            std::istringstream cells(line);
            std::string cell;
            for (long i = 0; i <= index; ++i)
                std::getline(cells, cell, ',');
            values.push_back(std::stod(cell));
        }
        return values;
    }

    /// A slab running down, in cell units.
    std::string slab_scene() const {
        return write("slab.json", R"({"format": "pastoso-scene", "version": 1, "cell_units": true,
            "size_cells": [24, 16], "edges": "periodic", "paint": {"viscosity_cells2_s": 1},
            "gravity": {"normal_cells_s2": 1, "y_cells_s2": 0.3},
            "film": [{"kind": "slab", "thickness_cells": 2, "pigment": "PR108"}], "duration_s": 20,
            "output": {"series_every_s": 5, "picture_scale": 2, "profiles_along_y_at_x_cells": [12]}})");
    }
};

TEST_F(CliSimulate, ASlabRunsAtNusseltsSpeed) {
    const RunResult run = run_cli({"simulate", slab_scene(), "-o", path("out"), "-q"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
    EXPECT_THAT(column("out/series.csv", "t_s"), testing::ElementsAre(0, 5, 10, 15, 20));
    EXPECT_THAT(column("out/series.csv", "volume_cells3"), testing::Each(768.0));
    // F h^2 / (3 nu) = 0.4; the start has decayed by exp(-15), floats keep 1e-6.
    EXPECT_THAT(column("out/profile_y.csv", "v_cells_s"), testing::Each(testing::DoubleNear(0.4, 4e-5)));
    EXPECT_NEAR(column("out/series.csv", "kinetic_energy").back(), 0.5 * 768 * 0.16, 0.02);
    const files::GreyImage height = files::read_grey_image(path("out/height-20s.exr"));
    EXPECT_EQ(height.width, 24);
    EXPECT_THAT(height.values, testing::Each(2.0F));
    EXPECT_EQ(files::read_grey_image(path("out/picture-20s.png")).height, 32);
}

TEST_F(CliSimulate, AllFilesAreThereAndNoOthers) {
    ASSERT_EQ(run_cli({"simulate", "paper-fig2", "--seconds", "0.02", "-o", path("out"), "--stats",
                       path("stats.json")})
                  .status,
              0);
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.insert(std::filesystem::relative(entry, folder).string());
    }
    std::set<std::string> expected = {"stats.json", "out/report.json", "out/pictures.png"};
    for (const std::string run : {"alpha-range", "alpha-1", "equal-mean-drag"})
        for (const char* file : {"/series.csv", "/profile_x.csv", "/picture-0s.png"})
            expected.insert("out/" + run + file);
    EXPECT_EQ(files, expected);
    const Json stats = Json::parse(text("stats.json"));
    EXPECT_EQ(stats["runs"].size(), 3U);
    EXPECT_EQ(stats["runs"][0]["film_steps"], 5);
    EXPECT_EQ(stats["runs"][0]["clamped_faces"], 0);
    const Json report = Json::parse(text("out/report.json"));
    EXPECT_EQ(report["runs"][1]["name"], "alpha-1");
    EXPECT_NEAR(report["runs"][1]["moments"][0]["front"]["roundness"], 1.0, 0.05);
}

TEST_F(CliSimulate, EverySceneThatComesWithTheProgramRuns) {
    for (const std::string& name : recordings::bundled_scene_names()) {
        const RunResult run = run_cli({"simulate", name, "--seconds", "0.02", "-o", path(name), "-q",
                                       "--stats", path(name + ".json")});
        EXPECT_EQ(run.status, 0) << run.errors;
        const Json stats = Json::parse(text(name + ".json"));
        for (const Json& figures : stats["runs"]) {
            EXPECT_GT(figures["film_steps"], 0) << name;
            EXPECT_EQ(figures["clamped_faces"], 0) << name;
        }
    }
}

TEST_F(CliSimulate, ThePapersScenesTakeThePapersSteps) {
    for (const std::string name : {"paper-fig3", "paper-fig4", "paper-fig5", "paper-fig6"}) {
        const RunResult run =
            run_cli({"simulate", name, "--seconds", "0.04", "-o", path(name), "--threads", "1"});
        EXPECT_EQ(run.status, 0) << run.errors;
        EXPECT_THAT(run.output, HasSubstr("Baba and Saito, figure " + name.substr(9)));
        EXPECT_EQ(column(name + "/series.csv", "steps").back(), 10) << name;
        EXPECT_EQ(column(name + "/series.csv", "clamped_faces").back(), 0) << name;
    }
}

TEST_F(CliSimulate, ThreadsDoNotShowInAnyFile) {
    for (const char* threads : {"1", "3"}) {
        ASSERT_EQ(run_cli({"simulate", "paper-fig5", "--seconds", "0.2", "-o", path(threads),
                           "--threads", threads})
                      .status,
                  0);
    }
    int compared = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("1"))) {
        const auto name = std::filesystem::relative(entry, path("1"));
        EXPECT_EQ(core::read_text_file(entry), core::read_text_file(folder / "3" / name)) << name;
        ++compared;
    }
    EXPECT_EQ(compared, 3);  // the series, the report, a picture at 0 s
}

// A processor that lacks a set runs the widest it has instead.
TEST_F(CliSimulate, EveryInstructionSetGivesTheSameBits) {
    for (const std::string scheme : {"explicit", "large-step"}) {
        const std::string scene = write(scheme + ".json", R"({"format": "pastoso-scene", "version": 1,
            "size_mm": [20, 18], "cell_mm": 0.25, "edges": "open", "paint": "house paint",
            "support": {"kind": "weave", "thread_pitch_mm": 0.8, "relief_mm": 0.1}, "tilt": {"tilt_deg": 70, "direction_deg": 60},
            "film": [{"kind": "cap", "at_mm": [8, 7], "radius_mm": 5, "thickness_mm": 1, "pigment": "PB29"},
                     {"kind": "cap", "at_mm": [13, 8], "radius_mm": 4, "thickness_mm": 1.5,
                      "paint": "heavy-body oil", "pigment": "PY35"}],
            "solver": {"scheme": ")" + scheme + R"("}, "duration_s": 0.1})");
        std::set<std::string> hashes;
        for (const char* isa : {"baseline", "avx2", "avx512"}) {
            ::setenv("PASTOSO_ISA", isa, 1);
            const RunResult run = run_cli(
                {"simulate", scene, "-o", path(scheme + isa), "--stats", path("stats.json"), "-q"});
            ::unsetenv("PASTOSO_ISA");
            ASSERT_EQ(run.status, 0) << run.errors;
            const Json figures = Json::parse(text("stats.json")).at("runs").at(0);
            EXPECT_EQ(figures.at("large_steps") > 0, scheme == "large-step");
            hashes.insert(figures.at("state_hash"));
        }
        EXPECT_EQ(hashes.size(), 1U) << scheme;
    }
}

TEST_F(CliSimulate, TheMagnifiedPictureHasBothHalves) {
    const std::string scene = write("a.json", R"({"format": "pastoso-scene", "version": 1,
        "size_mm": [20, 10], "cell_mm": 0.5, "paint": "house paint", "duration_s": 0,
        "film": [{"kind": "cap", "at_mm": [5, 5], "radius_mm": 3, "thickness_mm": 1, "pigment": "PB29"}],
        "output": {"magnified": {"at_s": 0, "scale": 8, "cells": [0, 0, 20, 20]}}})");
    ASSERT_EQ(run_cli({"simulate", scene, "-o", path("out"), "-q"}).status, 0);
    const files::GreyImage image = files::read_grey_image(path("out/magnified-0s.png"));
    EXPECT_EQ(image.width, 160 + 16 + 160);
    EXPECT_EQ(image.height, 160);
    EXPECT_EQ(image.values[168], 1.0F);
}

TEST_F(CliSimulate, BadRequestsAreRefusedInOneSentence) {
    const std::string slab = slab_scene(), out = path("out");
    expect_refusal({"simulate", slab}, 2, "--output is required");
    expect_refusal({"simulate", slab, "-o", out, "--seconds", "-1"}, 2, "-1");
    expect_refusal({"simulate", path("no.json"), "-o", out}, 1,
                   "no.json: cannot be opened (No such file or directory).");
    expect_refusal({"simulate", "paper-fig1", "-o", out}, 1, "There is no scene \"paper-fig1\"");
    expect_refusal({"simulate", folder.string(), "-o", out}, 1, "is a folder, not a file.");
    expect_refusal({"simulate", write("cut.json", "{\"format\": "), "-o", out}, 1,
                   "cut.json, line 1: this is not valid JSON");
    expect_refusal({"simulate", slab, "-o", path("missing/out")}, 1,
                   "missing/out: cannot be created (No such file or directory).");
    expect_refusal({"simulate", slab, "-o", "/proc/out"}, 1, "/proc/out: cannot be created");
    expect_refusal({"simulate", slab, "-o", slab}, 1, "slab.json");
    expect_refusal({"simulate", slab, "-o", out, "--stats", path("missing/a.json")}, 1,
                   "missing/a.json: cannot be written");
}

TEST_F(CliSimulate, ScenesThatCannotRunAreRefusedBeforeAFolderIsMade) {
    Json scene = Json::parse(core::read_text_file(slab_scene()));
    scene["film"].push_back(scene["film"][0]);
    scene["film"][0]["thickness_cells"] = 14;
    expect_refusal({"simulate", write("thick.json", scene.dump()), "-o", path("out")}, 1,
                   "thick.json: The thickness of the film is 16 in cell (0, 0)");
}

TEST_F(CliSimulate, InterruptedRunsLeaveWholeFilesOnly) {
    const RunResult run = interrupt_program(
        "pastoso-cli", {"simulate", "paper-fig5", "-o", path("out"), "-q"}, path("out/picture-0s.png"));
    EXPECT_EQ(run.status, 130);
    EXPECT_EQ(run.errors, "pastoso-cli: stopped.\n");
    EXPECT_FALSE(std::filesystem::exists(path("out/series.csv")));
    for (const auto& entry : std::filesystem::directory_iterator(path("out")))
        EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry;
}

}  // namespace
}  // namespace pastoso::cli
