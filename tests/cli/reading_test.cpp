// What the program is given to read, and what it prints, seen from outside.
#include "cli/run_program.hpp"
#include "core/resources.hpp"
#include "core/text_file.hpp"

#include <cstdlib>
#include <sys/stat.h>
#include <sys/wait.h>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The exit status of a shell command in which $0 is the program.
int shell_status(const std::string& command) {
    const std::string program = (core::program_folder() / "pastoso-cli").string();
    const int status = std::system(("sh -c '" + command + "' '" + program + "'").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class CliReading : public CliTest {
  protected:
    std::string pipe(const std::string& name) const {
        EXPECT_EQ(::mkfifo(path(name).c_str(), 0600), 0);
        return path(name);
    }
};

TEST_F(CliReading, PipesAndDevicesAreRefusedWhereverAFileIsRead) {
    const std::string pen = short_recording();
    const std::string refused = ": is a named pipe, not a file.";
    const std::string text = pipe("a.dat"), json = pipe("b.json"), png = pipe("c.png"),
                      mesh = pipe("d.obj"), painting = pipe("e.pastoso"), ora = pipe("f.ora"),
                      icc = pipe("g.icc"), csv = pipe("h.csv"), gpl = pipe("i.gpl"),
                      brush = pipe("j.json");
    const std::string out = path("out.png");
    expect_refusal({"replay", text}, 1, text + refused);
    expect_refusal({"replay", json}, 1, json + refused);
    expect_refusal({"replay", "/dev/zero"}, 1, "/dev/zero: is a device, not a file.");
    expect_refusal({"timelapse", json, "-o", path("film")}, 1, json + refused);
    expect_refusal({"info", png}, 1, png + refused);
    expect_refusal({"info", painting}, 1, painting + refused);
    expect_refusal({"info", "palette", gpl}, 1, gpl + refused);
    expect_refusal({"export", painting, "-o", out}, 1, painting + refused);
    expect_refusal({"convert", png, path("x.pastoso")}, 1, png + refused);
    expect_refusal({"convert", ora, path("x.pastoso")}, 1, ora + refused);
    expect_refusal(small({"replay", pen, "--support", png}), 1, png + refused);
    expect_refusal(small({"replay", pen, "--palette", gpl}), 1, gpl + refused);
    expect_refusal(small({"replay", pen, "--brush", brush}), 1, brush + refused);
    expect_refusal(small({"replay", pen, "-o", out, "--profile", icc}), 1, icc + refused);
    expect_refusal(small({"replay", pen, "-o", out, "--light", csv}), 1, csv + refused);
    for (const char* command : {"simulate", "tank"})
        expect_refusal({command, json, command == std::string("tank") ? "--frames" : "-o", path("out")},
                       1, json + refused);
    expect_refusal({"tea", json, "--frames", path("out")}, 1, json + refused);
}

TEST_F(CliReading, SoAreThoseThatAFileNames) {
    const std::string png = pipe("height.png");
    const std::string recording =
        write("a.json", R"({"format":"pastoso-strokes","version":1,"canvas":{"width_mm":20,)"
                        R"("height_mm":20,"support":"image","support_image":")" +
                            png + R"("},"end_tick":0,"events":[]})");
    expect_refusal({"replay", recording}, 1, png + ": is a named pipe, not a file.");
}

TEST_F(CliReading, WhatIsWrongInAFileIsToldWithItsName) {
    const auto recording = [&](const std::string& canvas) {
        return write("a.json", R"({"format":"pastoso-strokes","version":1,"canvas":{"width_mm":20,)"
                               R"("height_mm":20,)" +
                                   canvas + R"(},"end_tick":0,"events":[]})");
    };
    for (const auto& [canvas, sentence] :
         {std::pair{R"("support":"cardboard")", "There is no support"},
          {R"("support":"image")", "needs a height image; none is named."},
          {R"("support":"image","support_image":"none.png")", "none.png: cannot be opened"}}) {
        expect_refusal({"replay", recording(canvas)}, 1, path("a.json") + ": ");
        expect_refusal({"replay", recording(canvas)}, 1, sentence);
        expect_refusal({"timelapse", recording(canvas), "-o", path("film.mp4")}, 1,
                       path("a.json") + ": ");
    }
}

TEST_F(CliReading, NamesThatAreNoUtf8DoNotEndTheWork) {
    const std::string picture = path("\xff.png");
    ASSERT_EQ(run_cli(small({"replay", "-q", short_recording(), "-o", picture})).status, 0);
    const RunResult run = run_cli(small({"replay", "-q", short_recording(), "--support", picture,
                                         "--save", path("a.pastoso"), "--stats", path("a.stats")}));
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run_cli({"info", path("a.pastoso")}).status, 0);
    EXPECT_EQ(run_cli({"convert", "-q", picture, path("b.pastoso")}).status, 0);
    EXPECT_EQ(run_cli({"info", path("b.pastoso")}).status, 0);
}

TEST_F(CliReading, PathsThatCannotBeLookedAtAreToldInASentence) {
    std::filesystem::create_symlink("loop.pastoso", path("loop.pastoso"));
    const std::string loop = path("loop.pastoso"), longest = path(std::string(300, 'a') + ".png");
    const std::string told = ": cannot be opened (Too many levels of symbolic links).";
    expect_refusal({"info", loop}, 1, loop + told);
    expect_refusal({"export", loop, "-o", path("a.png")}, 1, loop + told);
    expect_refusal({"convert", loop, path("a.png")}, 1, loop + told);
    expect_refusal({"replay", loop}, 1, loop + told);
    expect_refusal({"info", longest}, 1, longest + ": cannot be opened (File name too long).");
    expect_refusal(small({"replay", short_recording(), "--light", std::string(300, 'a')}), 1,
                   "There is no light");
}

TEST_F(CliReading, OutputThatDoesNotArriveIsAnError) {
    const std::string errors = path("errors");
    for (const std::string command :
         {"info", "info paints", "--help", "tank --help", "--version", "info closest \"#7a5c3e\""}) {
        EXPECT_EQ(shell_status("\"$0\" " + command + " > /dev/full 2> " + errors), 1) << command;
        EXPECT_EQ(core::read_text_file(errors),
                  "pastoso-cli: the standard output: cannot be written (No space left on device).\n")
            << command;
    }
}

TEST_F(CliReading, OutputThatIsLostInTheMiddleIsAnError) {
    const std::string errors = path("errors");
    EXPECT_EQ(shell_status("stdbuf -o 64 \"$0\" info > /dev/full 2> " + errors), 1);
    EXPECT_EQ(core::read_text_file(errors),
              "pastoso-cli: the standard output: cannot be written (No space left on device).\n");
}

TEST_F(CliReading, AnUnknownInstructionSetIsRefused) {
    const std::string errors = path("errors");
    EXPECT_EQ(shell_status("PASTOSO_ISA=avx1024 \"$0\" info > /dev/null 2> " + errors), 1);
    EXPECT_EQ(core::read_text_file(errors),
              "pastoso-cli: PASTOSO_ISA is \"avx1024\", but there are baseline, avx2 and avx512.\n");
    for (const char* known : {"baseline", "avx2", "avx512"})
        EXPECT_EQ(shell_status("PASTOSO_ISA=" + std::string(known) + " \"$0\" info > /dev/null"), 0);
}

TEST_F(CliReading, EscapesInFilesAndNamesDoNotReachTheTerminal) {
    const std::string palette = write("a.gpl", "GIMP Palette\nName: a\x1b[2J\n1 2 3 b\x1b]0;title\a\n");
    const RunResult run = run_cli({"info", "palette", palette});
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("name: a\\x1b[2J\n"));
    EXPECT_THAT(run.output, HasSubstr("b\\x1b]0;title\\x07"));
    const RunResult refused = run_cli({"replay", path("no\x1b[31m.dat")});
    EXPECT_THAT(refused.errors, HasSubstr("no\\x1b[31m.dat: cannot be opened"));
    for (const std::string& text : {run.output, run.errors, refused.errors})
        EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace pastoso::cli
