// What "export" makes of a painting besides the usual picture.
#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "source_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class CliExport : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        painting = path("a.pastoso");
        const RunResult run =
            run_cli(small({"replay", "-q", short_recording(), "--save", painting, "--paint", "PR108"}));
        ASSERT_EQ(run.status, 0) << run.errors;
    }

    RunResult run_export(std::vector<std::string> options) const {
        options.insert(options.begin(), {"export", "-q", painting, "-o"});
        return run_cli(options);
    }

    std::string painting;
};

TEST_F(CliExport, EveryFormatOfPicturesIsWritten) {
    for (const char* name : {"b.png", "b.tif", "b.jpg", "b.webp", "b.exr"}) {
        const RunResult run = run_export({path(name)});
        EXPECT_EQ(run.status, 0) << run.errors;
        EXPECT_EQ(run.output, path(name) + ": 80 x 60 pixels\n");
        EXPECT_EQ(files::read_grey_image(path(name)).width, 80);
    }
    EXPECT_EQ(run_export({path("c.tif"), "--depth", "32"}).status, 0);
    EXPECT_EQ(run_export({path("c.jpg"), "--quality", "20"}).status, 0);
    EXPECT_LT(std::filesystem::file_size(path("c.jpg")), std::filesystem::file_size(path("b.jpg")));
    EXPECT_EQ(run_export({path("c.exr"), "--layers"}).status, 0);
    EXPECT_THAT(core::read_text_file(path("c.exr")), HasSubstr("Paint.height_mm.V"));
}

TEST_F(CliExport, FlatPicturesDoNotKnowTheLight) {
    ASSERT_EQ(run_export({path("b.png")}).status, 0);
    ASSERT_EQ(run_export({path("c.png"), "--flat"}).status, 0);
    ASSERT_EQ(run_export({path("d.png"), "--maps"}).status, 0);
    EXPECT_NE(core::read_text_file(path("c.png")), core::read_text_file(path("b.png")));
    EXPECT_EQ(core::read_text_file(path("c.png")), core::read_text_file(path("d-basecolor.png")));
}

TEST_F(CliExport, CopiesInLayersAreForOtherPrograms) {
    for (const char* name : {"b.ora", "b.psd"}) {
        const RunResult run = run_export({path(name)});
        EXPECT_EQ(run.status, 0) << run.errors;
        EXPECT_EQ(run.output, path(name) + ": 80 x 60 pixels, layers: 1\n");
    }
    EXPECT_EQ(files::read_grey_image(path("b.psd")).width, 80);
    ASSERT_EQ(run_cli({"convert", "-q", path("b.ora"), "-o", path("c.pastoso")}).status, 0);
    EXPECT_EQ(run_cli({"export", "-q", path("c.pastoso"), "-o", path("d.psd")}).status, 0);
}

TEST_F(CliExport, ConvertOfAPaintingIsTheSame) {
    ASSERT_EQ(run_export({path("b.png")}).status, 0);
    const RunResult run = run_cli({"convert", "-q", painting, "-o", path("c.png")});
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(core::read_text_file(path("b.png")), core::read_text_file(path("c.png")));
}

TEST_F(CliExport, MapsAreASetOfFiles) {
    const RunResult run = run_export({path("b.png"), "--maps", "--scale", "2"});
    ASSERT_EQ(run.status, 0) << run.errors;
    for (const char* name : {"b-basecolor.png", "b-normal.png", "b-height.png", "b-roughness.png"}) {
        EXPECT_THAT(run.output, HasSubstr(path(name) + ": 160 x 120 pixels\n"));
        EXPECT_EQ(files::read_grey_image(path(name)).width, 160);
    }
    EXPECT_THAT(run.output, HasSubstr("mm (white) on a canvas 40 mm wide\n"));
    EXPECT_FALSE(std::filesystem::exists(path("b.png")));
}

TEST_F(CliExport, ReliefsTellTheirSize) {
    for (const char* name : {"b.stl", "b.ply", "b.obj"}) {
        const RunResult run = run_export({path(name), "--base-mm", "1", "--resolution-mm", "1"});
        EXPECT_EQ(run.status, 0) << run.errors;
        // 41 x 31 points: 2 x 40 x 30 triangles in front, 3 for each of the 140 along the border.
        EXPECT_EQ(run.output, path(name) + ": 2820 triangles, 40 x 30 mm\n");
    }
    EXPECT_EQ(std::filesystem::file_size(path("b.stl")), 84U + 50U * 2820U);
}

TEST_F(CliExport, WhatCannotBeDoneIsToldInASentence) {
    const auto refuse = [&](std::vector<std::string> options, int status, const std::string& sentence) {
        options.insert(options.begin(), {"export", "-q", painting, "-o"});
        expect_refusal(options, status, sentence);
    };
    refuse({path("b.gif")}, 1, "b.gif: a picture is saved as .png, .tif, .jpg, .webp or .exr");
    refuse({path("b.png"), "--depth", "32"}, 1, "b.png: .png files do not hold 32-bit pictures.");
    refuse({path("b.png"), "--layers"}, 1, "b.png: only .exr files hold layers.");
    refuse({path("b.jpg"), "--maps"}, 1, "b.jpg: maps are saved as .png, .tif or .exr");
    refuse({path("b.stl"), "--maps"}, 2, "--layers and --maps are for pictures; " + path("b.stl"));
    refuse({path("b.psd"), "--layers"}, 2, path("b.psd") + " is a copy in layers.");
    refuse({path("b.ora"), "--scale", "2"}, 2, "--flat and --scale are not for copies in layers");
    refuse({path("b.exr"), "--maps", "--layers"}, 2, "--layers and --maps exclude each other.");
    refuse({path("b.stl"), "--base-mm", "-1"}, 2, "--base-mm: \"-1\" is no number from 0.1 to 100");
    refuse({path("b.jpg"), "--quality", "0"}, 2, "--quality");
    refuse({path("missing/b.stl")}, 1, "missing/b.stl: cannot be written (No such file or directory).");
    refuse({path("b.tif"), "--depth", "32", "--profile", write("p.icc", "none")}, 1, "p.icc: is no ICC");
    refuse({path("b.png"), "--scale", "65"}, 2, "65");
}

TEST_F(CliExport, PaintedAgainItIsWhatAReplayOnSuchCellsIs) {
    ASSERT_EQ(run_export({path("finer.pastoso"), "--again", "6"}).status, 0);
    const RunResult direct = run_cli({"replay", "-q", short_recording(), "--canvas", "40x30mm",
                                      "--px-per-mm", "6", "--seconds", "0.1", "--size-mm", "8",
                                      "--paint", "PR108", "--save", path("direct.pastoso")});
    ASSERT_EQ(direct.status, 0) << direct.errors;
    EXPECT_EQ(core::read_text_file(path("finer.pastoso")), core::read_text_file(path("direct.pastoso")));
    const RunResult picture =
        run_export({path("again.png"), "--again", "6", "--well", path("well.png")});
    EXPECT_THAT(picture.output, HasSubstr(path("again.png") + ": 240 x 180 pixels\n"));
    ASSERT_EQ(run_cli({"export", "-q", path("finer.pastoso"), "-o", path("finer.png")}).status, 0);
    EXPECT_EQ(core::read_text_file(path("again.png")), core::read_text_file(path("finer.png")));
}

TEST_F(CliExport, WhatItTakesToPaintItAgainIsSaidBefore) {
    const RunResult run = run_cli({"export", painting, "--again", "4", "-o", path("b.pastoso")});
    EXPECT_THAT(run.output,
                MatchesRegex("painting 160 x 120 cells, which takes about [1-9][0-9]* MiB of memory\n" +
                             path("b.pastoso") + ": the painting in 160 x 120 cells\n"));
}

TEST_F(CliExport, PicturesAndOldStrokesAreSaidBeforeTheyArePaintedAgain) {
    ASSERT_EQ(run_export({path("b.png")}).status, 0);
    const RunResult old = run_cli({"export", "-q", tests::source_file("tests/project/format-3.pastoso"),
                                   "--again", "5", "-o", path("old.pastoso")});
    EXPECT_EQ(old.status, 0);
    EXPECT_THAT(old.errors,
                HasSubstr("format-3.pastoso: its strokes were painted with an earlier version"));
    ASSERT_EQ(run_cli({"convert", "-q", path("b.png"), "-o", path("picture.pastoso")}).status, 0);
    const RunResult picture =
        run_cli({"export", "-q", path("picture.pastoso"), "--again", "5", "-o", path("c.png")});
    EXPECT_EQ(picture.status, 0) << picture.errors;
    EXPECT_THAT(picture.errors, HasSubstr("picture.pastoso: a picture on it has no strokes"));
}

TEST_F(CliExport, WhatCannotBeMadeOfItIsSaidBeforeItIsPaintedAgain) {
    const RunResult large =
        run_cli({"export", painting, "--again", "20", "--scale", "64", "-o", path("b.png")});
    EXPECT_EQ(large.status, 1);
    EXPECT_THAT(large.errors, HasSubstr("larger than"));
    EXPECT_EQ(large.output, "") << "nothing was begun";
    EXPECT_EQ(run_cli({"export", painting, "--again", "4", "-o", painting}).status, 2);
}

TEST_F(CliExport, APaintingIsNoPicture) {
    const RunResult run = run_export({path("b.pastoso")});
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.errors, HasSubstr("--again PX_PER_MM"));
    EXPECT_EQ(run_export({path("b.pastoso"), "--again", "4", "--maps"}).status, 2);
}

}  // namespace
}  // namespace pastoso::cli
