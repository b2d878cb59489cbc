#include "cli/run_program.hpp"

#include <algorithm>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;

class CliErrors : public CliTest {
  protected:
    void expect_bad_input(const std::vector<std::string>& arguments, const std::string& sentence) {
        expect_refusal(arguments, 1, sentence);
    }
    void expect_bad_usage(const std::vector<std::string>& arguments, const std::string& sentence) {
        expect_refusal(arguments, 2, sentence);
    }
};

TEST_F(CliErrors, UsageErrorsEndWithStatusTwo) {
    const std::string pen = short_recording();
    expect_bad_usage({}, "subcommand");
    expect_bad_usage({"paint"},
                     "there is no subcommand \"paint\", only replay, sheet, export, convert, timelapse, "
                     "recover, thumbnail, simulate, validate, tea, tank and info.");
    expect_bad_usage({"replay"}, "STROKES");
    expect_bad_usage({"replay", pen, "--brushes", "x"}, "no place for the argument \"--brushes\"");
    expect_bad_usage({"replay", "--nonsense"}, "no place for the argument \"--nonsense\"");
    expect_bad_usage({"replay", pen, "-o", "out.png", "extra"}, "no place for the argument \"extra\"");
    expect_bad_usage({"replay", pen, "--tilt", "steep"}, "steep");
    expect_bad_usage({"replay", pen, "--threads", "-1"}, "-1");
    expect_bad_usage({"replay", pen, "--canvas", "large"}, "--canvas: \"large\" is not a size");
    expect_bad_usage({"replay", pen, "--paint", "PB29=+PW6"}, "--paint: \"PB29=+PW6\" is not a paint");
}

TEST_F(CliErrors, MissingAndMalformedRecordings) {
    expect_bad_input({"replay", path("no.dat")},
                     "no.dat: cannot be opened (No such file or directory).");
    expect_bad_input({"replay", path("no.json")},
                     "no.json: cannot be opened (No such file or directory).");
    expect_bad_input({"replay", folder.string()}, "is a folder, not a file.");
    expect_bad_input({"replay", write("empty.dat", "")}, "empty.dat: holds no stroke");
    expect_bad_input({"replay", write("a.dat", "0 1 2 0.5\n0.1 x 2 0.5\n")},
                     "a.dat, line 2: the x \"x\" is not a number.");
    expect_bad_input({"replay", write("b.dat", "0 1 nan 0.5\n")}, "b.dat, line 1: the y \"nan\"");
    expect_bad_input({"replay", write("c.dat", "0 1 2 -1\n")}, "c.dat, line 1: the pressure -1");
    expect_bad_input({"replay", write("d.dat", "1 1 2 0.5\n0 1 2 0.5\n")},
                     "d.dat, line 2: the time 0 s is earlier");
    expect_bad_input({"replay", write("e.json", "{")}, "e.json, line 1: this is not valid JSON");
    expect_bad_input({"replay", write("f.json", "{}")}, "f.json: this is not a stroke recording");
}

TEST_F(CliErrors, UnknownNames) {
    const std::string pen = short_recording();
    expect_bad_input(small({"replay", pen, "--brush", "broom"}), "broom");
    expect_bad_input(small({"replay", pen, "--paint", "PB999"}), "PB999");
    expect_bad_input(small({"replay", pen, "--medium", "honey"}), "honey");
    expect_bad_input(small({"replay", pen, "--support", "paper"}), "paper");
    expect_bad_input(small({"replay", pen, "--support", "relief.png"}), "relief.png: cannot be opened");
}

TEST_F(CliErrors, AbsurdCanvasesAndValues) {
    const std::string pen = short_recording();
    expect_bad_input({"replay", pen, "--canvas", "0x100mm"}, "The width of the canvas is 0 mm");
    expect_bad_input({"replay", pen, "--canvas", "5000x5000mm", "--px-per-mm", "6.5"},
                     "A canvas of 5000 x 5000 mm at 6.5 px/mm needs about");
    expect_bad_input({"replay", pen, "--canvas", "5000x5000mm", "--px-per-mm", "60"},
                     "at most 32768 a side");
    expect_bad_usage(small({"replay", pen, "--tilt", "120"}),
                     "--tilt: \"120\" is no number from 0 to 90");
    expect_bad_usage({"replay", pen, "--size-mm", "1000"},
                     "--size-mm: \"1000\" is no number from 0.5 to 200");
}

TEST_F(CliErrors, UnwritableOutputsAreFoundBeforeTheWork) {
    const std::string pen = short_recording();
    expect_bad_input(small({"replay", pen, "-o", path("missing/a.png")}),
                     "missing/a.png: cannot be written (No such file or directory).");
    expect_bad_input(small({"replay", pen, "-o", path("a.bmpx")}),
                     "a.bmpx: a picture is saved as .png, .tif, .jpg, .webp or .exr");
    expect_bad_input(small({"replay", pen, "--stats", path("missing/a.json")}),
                     "missing/a.json: cannot be written");
    expect_bad_input(small({"replay", pen, "--frames", path("missing/frames")}),
                     "missing/frames: cannot be created");
    expect_bad_input(small({"replay", pen, "-o", "/proc/a.png"}), "/proc/a.png: cannot be written");
}

TEST_F(CliErrors, StrokesThatMissTheCanvas) {
    const std::string far = write("far.dat", "0 500 500 0.5\n1 600 500 0.5\n");
    expect_bad_input(small({"replay", far}),
                     "far.dat: every stroke misses the canvas; positions are taken as millimetres");
}

TEST_F(CliErrors, OptionsOfTextRecordingsDoNotGoWithJson) {
    const std::string json =
        write("a.json", R"({"format":"pastoso-strokes","version":1,"canvas":{"width_mm":20,)"
                        R"("height_mm":20},"end_tick":0,"events":[]})");
    expect_bad_usage({"replay", json, "--brush", "flat"},
                     "--brush, --size-mm, --paint, --palette and --fit are for text recordings");
    expect_bad_usage({"replay", json, "--fit"}, "are for text recordings");
}

TEST_F(CliErrors, InfoOnWhatIsNoRecordingAndNoImage) {
    expect_bad_input({"info", write("a.png", "no picture")}, "a.png: is not an image that can be read");
    expect_bad_input({"info", write("a.txt", "no recording")}, "a.txt, line 1: expected 4 numbers");
}

}  // namespace
}  // namespace pastoso::cli
