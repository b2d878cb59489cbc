#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "source_file.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;

class CliReplay : public CliTest {
  protected:
    nlohmann::json stats_of(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--stats", path("stats.json"), "-o", path("out.png")});
        const RunResult run = run_cli(arguments);
        EXPECT_EQ(run.status, 0) << run.errors;
        return nlohmann::json::parse(core::read_text_file(path("stats.json")));
    }
};

TEST_F(CliReplay, PaintsAPictureAndTellsWhere) {
    const RunResult run = run_cli(small({"replay", short_recording(), "-o", path("out.png")}));
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr(path("out.png") + ": 80 x 60 pixels\n"));
    EXPECT_THAT(run.output, HasSubstr("s of painting in "));
    EXPECT_THAT(run.errors, HasSubstr("painting: 100 %\n"));
    const files::GreyImage image = files::read_grey_image(path("out.png"));
    EXPECT_EQ(image.width, 80);
    // The stroke's paint is darker than the primed canvas in the corner.
    EXPECT_LT(image.values[30 * 80 + 40], 0.75F * image.values[2 * 80 + 2]);
    EXPECT_EQ(files_in_folder(), 2U);
}

TEST_F(CliReplay, QuietShowsNoProgress) {
    EXPECT_EQ(run_cli(small({"replay", short_recording(), "-q", "-o", path("out.png")})).errors, "");
}

TEST_F(CliReplay, TheFiguresBalance) {
    const auto stats =
        stats_of(small({"replay", short_recording(), "--medium", "house paint", "--tilt", "60"}));
    EXPECT_LT(stats["volume_error_rel"], 1e-9);
    EXPECT_LT(stats["pigment_error_rel"], 1e-9);
    EXPECT_GT(stats["volume_canvas_mm3"], 0.0);
    EXPECT_GT(stats["steps"], 0);
    EXPECT_EQ(stats["clamped_faces"], 0);
    EXPECT_GT(stats["wall_s"], stats["film_s"]);
    EXPECT_EQ(stats["image_hash"].get<std::string>().size(), 16U);
    EXPECT_NE(stats["image_hash"], "0000000000000000");
}

TEST_F(CliReplay, TheSameInputGivesTheSameHashesOnAnyNumberOfThreads) {
    const std::string pen = short_recording();
    const auto first =
        stats_of(small({"replay", pen, "--medium", "fluid acrylic", "--tilt", "60", "--threads", "1"}));
    for (const char* threads : {"1", "2", "3"}) {
        const auto again = stats_of(
            small({"replay", pen, "--medium", "fluid acrylic", "--tilt", "60", "--threads", threads}));
        EXPECT_EQ(again["state_hash"], first["state_hash"]);
        EXPECT_EQ(again["image_hash"], first["image_hash"]);
        EXPECT_EQ(again["threads"], std::stoi(threads));
    }
}

TEST_F(CliReplay, PaintsAPictureOfTheMixingWell) {
    core::write_text_file(
        path("well.json"),
        R"({"format":"pastoso-strokes","version":4,"canvas":{"width_mm":20,"height_mm":20},"end_tick":4,)"
        R"("events":[{"tick":0,"squeeze_paint":{"paint":{"mix":[["PB29",1]]},"x_mm":60,"y_mm":45}},)"
        R"({"tick":0,"take_brush":{"preset":"flat","size_mm":8}},)"
        R"({"tick":0,"stroke":{"surface":"well","samples":[[0,55,45,0.5],[0.05,65,45,0.5]]}}]})");
    const RunResult run = run_cli(
        {"replay", path("well.json"), "--well", path("well.png"), "-q", "--stats", path("stats.json")});
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr(path("well.png") + ": 360 x 270 pixels\n"));
    const files::GreyImage image = files::read_grey_image(path("well.png"));
    EXPECT_LT(image.values[135 * 360 + 180], 0.5F * image.values[20 * 360 + 20]);
    const auto stats = nlohmann::json::parse(core::read_text_file(path("stats.json")));
    EXPECT_GT(stats["volume_well_mm3"], 100.0);
    EXPECT_LT(stats["volume_error_rel"], 1e-12);
    EXPECT_THAT(run_cli({"info", path("well.json")}).output,
                HasSubstr("mixing well: 1 of the strokes, paint squeezed 1 times\n"));
}

TEST_F(CliReplay, WritesNumberedFrames) {
    // 0.19 s of stroke and 0.1 s after it make 17 ticks: frames at 0, 0.1 and 0.2 s.
    const RunResult run = run_cli(small(
        {"replay", short_recording(), "--frames", path("frames"), "--fps", "10", "--scale", "0.5"}));
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("frames: 3 frames"));
    for (const char* name :
         {"frames/frame-00001.png", "frames/frame-00002.png", "frames/frame-00003.png"}) {
        EXPECT_EQ(files::read_grey_image(path(name)).width, 40) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(path("frames/frame-00004.png")));
}

TEST_F(CliReplay, AnInterruptLeavesNothingHalfWritten) {
    const std::string pen = short_recording();
    const RunResult run =
        interrupt_program("pastoso-cli",
                          {"replay", pen, "--canvas", "40x30mm", "--seconds", "3600", "-o",
                           path("out.png"), "--frames", path("frames"), "--fps", "1"},
                          path("frames/frame-00001.png"));
    EXPECT_EQ(run.status, 130);
    EXPECT_THAT(run.errors, HasSubstr("pastoso-cli: stopped."));
    EXPECT_EQ(files_in_folder(), 2U) << "the recording and the folder of frames";
    for (const auto& file : std::filesystem::directory_iterator(path("frames"))) {
        EXPECT_EQ(files::read_grey_image(file.path()).width, 160) << file.path();
    }
}

TEST_F(CliReplay, WritesLinearPictures) {
    EXPECT_EQ(run_cli(small({"replay", short_recording(), "-q", "-o", path("out.exr")})).status, 0);
    EXPECT_EQ(files::read_grey_image(path("out.exr")).width, 80);
}

TEST_F(CliReplay, TakesPaintsInTurn) {
    const std::string two =
        write("two.dat", "0 10 10 0\n.1 10 10 .5\n.3 30 10 .5\n.4 30 10 0\n.5 10 22 .5\n.7 30 22 .5\n");
    EXPECT_EQ(run_cli(small({"replay", two, "-q", "--paint", "PBk7", "PW6=1+PY35=0.05", "-o",
                             path("out.png")}))
                  .status,
              0);
    const files::GreyImage image = files::read_grey_image(path("out.png"));
    EXPECT_LT(image.values[20 * 80 + 40], 0.4F);
    EXPECT_GT(image.values[44 * 80 + 40], 0.6F);
}

TEST_F(CliReplay, FitBringsScreenUnitsOntoTheCanvas) {
    const std::string far = write("far.dat", "0 500 500 0.5\n0.2 900 700 0.5\n");
    const auto stats = stats_of(small({"replay", far, "--fit"}));
    EXPECT_GT(stats["volume_canvas_mm3"], 0.0);
}

TEST_F(CliReplay, OptionsOverrideAJsonRecording) {
    const std::string json = write(
        "a.json",
        R"({"format":"pastoso-strokes","version":1,"canvas":{"width_mm":20,"height_mm":10,"px_per_mm":4},)"
        R"("end_tick":4,"events":[{"tick":0,"use_medium":{"name":"house paint"}},)"
        R"({"tick":0,"take_brush":{"preset":"flat","size_mm":6}},)"
        R"({"tick":0,"load_paint":{"paint":{"mix":[["PB29",1]]}}},)"
        R"({"tick":0,"stroke":{"samples":[[0,5,5,0.5],[0.05,10,5,0.5],[0.1,15,5,0.5]]}}]})");
    // As the recording has it: end_tick lies before the stroke's own ticks.
    EXPECT_THAT(run_cli({"replay", json}).errors,
                HasSubstr("a.json, end_tick: the tick 4 is earlier than 6"));
    const std::string good = write("b.json", [&] {
        std::string text = core::read_text_file(json);
        return text.replace(text.find("\"end_tick\":4"), 12, "\"end_tick\":9");
    }());
    const RunResult plain = run_cli({"replay", good, "-q", "-o", path("out.png")});
    EXPECT_THAT(plain.output, HasSubstr("80 x 40 pixels"));
    const RunResult coarse =
        run_cli({"replay", good, "-q", "--px-per-mm", "2", "--medium", "heavy-body oil", "--tilt", "45",
                 "--seconds", "1", "-o", path("out.png")});
    EXPECT_EQ(coarse.status, 0) << coarse.errors;
    EXPECT_THAT(coarse.output, HasSubstr("40 x 20 pixels"));
    EXPECT_THAT(coarse.output, HasSubstr("1.1 s of painting"));
}

TEST_F(CliReplay, InfoDescribesFiles) {
    EXPECT_EQ(run_cli(small({"replay", short_recording(), "-q", "-o", path("out.png")})).status, 0);
    EXPECT_THAT(run_cli({"info", path("out.png")}).output, HasSubstr("size: 80 x 60 pixels"));
    EXPECT_THAT(run_cli({"info", short_recording()}).output, HasSubstr("strokes: 1\n"));
}

TEST_F(CliReplay, ReplaysAPenRecordingOfManyStrokes) {
    const std::string pen = tests::source_file("tests/data/strokes/still-life.dat");
    const auto stats =
        stats_of({"replay", pen, "--fit", "--px-per-mm", "1.5", "--tilt", "60", "--seconds", "1", "-q"});
    EXPECT_LT(stats["volume_error_rel"], 1e-6);
    EXPECT_LT(stats["pigment_error_rel"], 1e-6);
    EXPECT_GT(stats["volume_canvas_mm3"], 500.0);
    EXPECT_EQ(stats["clamped_faces"], 0);
}

}  // namespace
}  // namespace pastoso::cli
