// The job array of packaging/slurm, without Slurm: a stand-in for sbatch runs the tasks.
#include "cli/run_program.hpp"
#include "core/resources.hpp"
#include "core/text_file.hpp"
#include "source_file.hpp"

#include <algorithm>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string kScript = tests::source_file("packaging/slurm/draw-tea.sh");
const std::string kPaintScript = tests::source_file("packaging/slurm/paint-again.sh");

const std::string kSbatch = tests::source_file("tests/cli/stand_in_sbatch.sh");

class RenderFarm : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        fs::create_directories(folder / "bin");
        fs::copy_file(kSbatch, path("bin/sbatch"));
    }

    /// Half a second of tea on a coarse grid, ten frames.
    void keep_tea() const {
        const RunResult run = run_cli(
            {"tea", "--grid", "16", "--seconds", "0.5", "--fps", "20", "--cache", path("kept"), "-q"});
        ASSERT_EQ(run.status, 0) << run.errors;
    }

    RunResult farm(const std::vector<std::string>& more, const std::string& script = kScript) const {
        std::vector<std::string> all = {"PATH=" + path("bin") + ":/usr/bin:/bin", "bash", script};
        all.insert(all.end(), more.begin(), more.end());
        return run_program("/usr/bin/env", all);
    }
    RunResult draw(std::vector<std::string> more) const {
        more.insert(more.begin(), {path("kept"), path("drawn"), "--program",
                                   (core::program_folder() / "pastoso-cli").string()});
        return farm(more);
    }

    RunResult paint(std::vector<std::string> more) const {
        more.insert(more.begin(), {path("paintings"), path("finer"), "--program",
                                   (core::program_folder() / "pastoso-cli").string()});
        return farm(more, kPaintScript);
    }

    std::vector<std::string> drawn(const std::string& name) const {
        std::vector<std::string> names;
        for (const fs::path& file : core::files_in(path(name), ".stl"))
            names.push_back(file.filename().string());
        return names;
    }
    std::string options() const { return core::read_text_file(path("bin/options")); }

    void expect_sentence(const RunResult& run, const std::string& sentence) const {
        EXPECT_NE(run.status, 0);
        EXPECT_THAT(run.errors, HasSubstr(sentence));
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_FALSE(fs::exists(path("bin/options")));
    }
};

TEST_F(RenderFarm, TasksDrawTogetherWhatOneMachineDrawsAlone) {
    keep_tea();
    const RunResult run = draw({"--per-task", "4", "--format", "stl", "--", "--partition=night"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("10 frames to draw, 3 tasks of up to 4 frames: job 77\n"));
    EXPECT_THAT(run.output, HasSubstr("scancel 77"));
    EXPECT_THAT(options(), testing::AllOf(HasSubstr("--array=1-3\n"), HasSubstr("--requeue\n"),
                                          HasSubstr("--partition=night\n")));
    ASSERT_EQ(
        run_cli({"tea", "render", path("kept"), "--frames", path("alone"), "--format", "stl", "-q"})
            .status,
        0);
    ASSERT_EQ(drawn("drawn").size(), 10U) << core::read_text_file(path("bin/log"));
    ASSERT_EQ(drawn("drawn"), drawn("alone"));
    for (const std::string& name : drawn("alone"))
        EXPECT_EQ(core::read_text_file(path("drawn/" + name)),
                  core::read_text_file(path("alone/" + name)))
            << name;
}

TEST_F(RenderFarm, TheSameCommandSubmitsWhatIsMissing) {
    keep_tea();
    write("bin/broken", "2\n");
    ASSERT_EQ(draw({"--per-task", "2", "--format", "stl"}).status, 0);
    EXPECT_EQ(drawn("drawn").size(), 8U);
    fs::remove(path("bin/broken"));
    fs::remove(path("drawn/milk_0009.stl"));
    const RunResult again = draw({"--per-task", "2", "--format", "stl"});
    EXPECT_THAT(again.output, HasSubstr("3 frames to draw, 2 tasks of up to 2 frames"));
    EXPECT_THAT(options(), HasSubstr("--array=2,5\n"));
    EXPECT_EQ(drawn("drawn").size(), 10U);
    EXPECT_THAT(draw({"--per-task", "2", "--format", "stl"}).output,
                HasSubstr("nothing is left to draw"));
}

TEST_F(RenderFarm, EverySoManyFramesOfPicturesAndScenes) {
    keep_tea();
    const RunResult pictures =
        draw({"--every", "4", "--per-task", "1", "--size", "8x8", "--samples", "1"});
    ASSERT_EQ(pictures.status, 0) << pictures.errors;
    EXPECT_THAT(options(), HasSubstr("--array=4,8\n"));
    EXPECT_TRUE(fs::exists(path("drawn/milk_0004.png")) && fs::exists(path("drawn/milk_0008.png")));
    ASSERT_EQ(draw({"--every", "10", "--format", "pbrt-scene"}).status, 0);
    EXPECT_THAT(draw({"--every", "10", "--format", "pbrt-scene"}).output, HasSubstr("nothing is left"));
}

TEST_F(RenderFarm, PaintingsArePaintedAgainEachByATask) {
    fs::create_directories(path("paintings"));
    for (const char* name : {"paintings/a.pastoso", "paintings/b c.pastoso", "paintings/d.pastoso"})
        ASSERT_EQ(run_cli(small({"replay", "-q", short_recording(), "--save", path(name)})).status, 0);
    write("bin/broken", "3\n");
    const RunResult first = paint({"--px-per-mm", "3"});
    ASSERT_EQ(first.status, 0) << first.errors;
    EXPECT_THAT(first.output,
                HasSubstr("3 of 3 paintings to paint at 3 cells per millimetre: job 77\n"));
    EXPECT_THAT(options(), HasSubstr("--array=1-3\n"));
    EXPECT_FALSE(fs::exists(path("finer/d.pastoso")));
    fs::remove(path("bin/broken"));
    EXPECT_THAT(paint({"--px-per-mm", "3"}).output, HasSubstr("1 of 1 paintings"));
    EXPECT_THAT(options(), HasSubstr("--array=1-1\n"));
    EXPECT_THAT(paint({"--px-per-mm", "3"}).output, HasSubstr("nothing is left to paint"));
    ASSERT_EQ(run_cli({"export", "-q", path("paintings/b c.pastoso"), "--again", "3", "-o",
                       path("alone.pastoso")})
                  .status,
              0);
    EXPECT_EQ(core::read_text_file(path("finer/b c.pastoso")),
              core::read_text_file(path("alone.pastoso")));
    EXPECT_THAT(paint({"--px-per-mm", "4"}).errors,
                HasSubstr("holds paintings on 3 cells per millimetre"));
    ASSERT_EQ(paint({"--px-per-mm", "3", "--format", "png"}).status, 0);
    EXPECT_TRUE(fs::exists(path("finer/d.png"))) << core::read_text_file(path("bin/log"));
}

TEST_F(RenderFarm, WhatCannotBePaintedAgainIsSaidInOneSentence) {
    fs::create_directories(path("paintings"));
    expect_sentence(paint({}), "--px-per-mm N says");
    expect_sentence(paint({"--px-per-mm", "fine"}), "--px-per-mm: \"fine\"");
    expect_sentence(paint({"--px-per-mm", "65"}), "--px-per-mm: \"65\"");
    expect_sentence(paint({"--px-per-mm", "0.2"}), "--px-per-mm: \"0.2\"");
    expect_sentence(paint({"--px-per-mm", "8", "--format", "gif"}), "--format: \"gif\"");
    expect_sentence(paint({"--px-per-mm", "8"}), "holds no paintings");
    expect_sentence(farm({path("paintings"), path("paintings"), "--px-per-mm", "8"}, kPaintScript),
                    "name another folder");
    EXPECT_FALSE(fs::exists(path("finer")));
}

TEST_F(RenderFarm, WhatCannotBeDrawnIsSaidInOneSentence) {
    expect_sentence(farm({}), "give the folder of kept frames");
    expect_sentence(farm({path("kept"), path("drawn")}), "there is no folder");
    fs::create_directories(path("empty"));
    const std::string program = (core::program_folder() / "pastoso-cli").string();
    expect_sentence(farm({path("empty"), path("drawn"), "--program", program}), "keeps no tea");
    expect_sentence(farm({path("empty"), path("drawn"), "--program", path("none")}),
                    "there is no pastoso-cli at");
    expect_sentence(farm({path("empty"), path("drawn"), "--per-task", "0"}), "--per-task: \"0\"");
    expect_sentence(farm({path("empty"), path("drawn"), "--per-task"}), "needs a value");
    expect_sentence(farm({path("empty"), path("drawn"), "--grid", "64"}), "there is no option '--grid'");
    keep_tea();
    expect_sentence(draw({"--every", "11"}), "has 10 frames");
    fs::remove(path("kept/frame_000003.tea"));
    fs::remove(path("kept/frame_000007.tea"));
    expect_sentence(draw({}), "2 of 10 frames are missing, the first is 3");
    EXPECT_FALSE(fs::exists(path("drawn")));
}

}  // namespace
}  // namespace pastoso::cli
