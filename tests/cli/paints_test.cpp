// "info" about paints and colours, and paints by their colour.
#include "cli/run_program.hpp"
#include "core/text_file.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// The user's data lies in the test's folder.
class CliPaints : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
    }
    void TearDown() override {
        ::unsetenv("XDG_DATA_HOME");
        CliTest::TearDown();
    }

    /// A pigment file with the K line `columns` long, among the user's.
    void write_pigment(const std::string& ci_name, int columns) const {
        std::string text = "ci_name,name,coef";
        for (int nm = 380; nm <= 730; nm += 10)
            text += "," + std::to_string(nm);
        text += "\n" + ci_name + ",Grandmother's blue,K";
        for (int i = 0; i < columns; ++i)
            text += i < 15 ? ",2" : ",80";
        text += "\n" + ci_name + ",Grandmother's blue,S";
        for (int i = 0; i < 36; ++i)
            text += ",30";
        std::filesystem::create_directories(folder / "pastoso/pigments");
        core::write_text_file(folder / "pastoso/pigments/mine.csv", text + "\n");
    }
};

std::string output_of(const std::vector<std::string>& arguments) {
    const RunResult run = run_cli(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return run.output;
}

TEST_F(CliPaints, ListsTheBoxAndTheOthers) {
    const std::string list = output_of({"info", "paints"});
    EXPECT_THAT(list, ContainsRegex("PW6 +#ff.* Titanium white"));
    EXPECT_THAT(list,
                ContainsRegex("PB29 +#[0-9a-f]+ +#[0-9a-f]+ +#[0-9a-f]+ +[0-9]+ % +[0-9]+  Ultra"));
    EXPECT_LT(list.find("PBk9"), list.find("Other paints"));
    EXPECT_GT(list.find("PBk7"), list.find("Other paints"));
    EXPECT_THAT(list, Not(HasSubstr("Your own")));
}

TEST_F(CliPaints, DescribesAPaintOrAColour) {
    EXPECT_THAT(output_of({"info", "paint", "PB29"}),
                testing::AllOf(HasSubstr("PB29: Ultramarine blue\n"), HasSubstr("undertone: #"),
                               HasSubstr("tinting strength: 1 part colours ")));
    EXPECT_THAT(output_of({"info", "paint", "#c03020"}), HasSubstr("masstone: #c03020\n"));
    expect_refusal({"info", "paint", "PB92"}, 1, "There is no pigment \"PB92\"");
    expect_refusal({"info", "paint"}, 2, "it is: pastoso-cli info paint PB29.");
}

TEST_F(CliPaints, FindsTheRecipeOfAColour) {
    const std::string found = output_of({"info", "closest", "#7a5c3e"});
    EXPECT_THAT(found, ContainsRegex("closest recipe: [0-9]+ P.* \\(dE [0-9.]+\\)"));
    EXPECT_THAT(found, HasSubstr("the colour's own paint: #7a5c3e (dE 0.0)"));
    EXPECT_THAT(output_of({"info", "closest", "#ffffff"}), HasSubstr("closest recipe: PW6 (dE"));
    EXPECT_THAT(output_of({"info", "closest", "#ff0000", "PB29"}),
                HasSubstr("closest recipe: PB29 (dE"));
    expect_refusal({"info", "closest", "#7a5c3"}, 1, "\"#7a5c3\" is not a colour");
    expect_refusal({"info", "closest", "PB29"}, 1, "\"PB29\" is a pigment, not a colour");
}

TEST_F(CliPaints, ReadsPalettesOfColours) {
    const std::string palette = write("skin.gpl", "GIMP Palette\nName: Skin\n255 224 196 Light\n");
    EXPECT_THAT(output_of({"info", "palette", palette}),
                testing::AllOf(HasSubstr("name: Skin\ncolours: 1\n"),
                               ContainsRegex("#ffe0c4  dE +[0-9.]+  [0-9]+ PW6 .* Light\n")));
    expect_refusal({"info", "palette", write("bad.gpl", "GIMP Palette\n1 2 x\n")}, 1,
                   "bad.gpl, line 2: the blue \"x\" is not a whole number from 0 to 255.");
}

TEST_F(CliPaints, PaintsWithColoursAndTheirNames) {
    const std::string pen = short_recording();
    const std::string palette = write("skin.gpl", "GIMP Palette\n255 224 196 Light\n");
    const std::string by_name = path("name.png"), by_colour = path("colour.png");
    output_of(small({"replay", pen, "--palette", palette, "--paint", "Light=2+PB29=1", "-o", by_name}));
    output_of(small({"replay", pen, "--paint", "#ffe0c4=2+PB29=1", "-o", by_colour}));
    EXPECT_EQ(core::read_text_file(by_name), core::read_text_file(by_colour));
}

TEST_F(CliPaints, RefusesColoursThatAreNone) {
    const std::string pen = short_recording();
    expect_refusal(small({"replay", pen, "--paint", "#c0302g"}), 1, "\"#c0302g\" is not a colour");
    expect_refusal(small({"replay", pen, "--palette", path("no.gpl"), "--paint", "PB29"}), 1,
                   "no.gpl: cannot be opened");
    const std::string recording = write(
        "a.json", R"({"format":"pastoso-strokes","version":3,"canvas":{"width_mm":20,"height_mm":20},)"
                  R"("end_tick":9,"events":[{"tick":0,"load_paint":{"paint":{"mix":[["#12",1]]}}}]})");
    expect_refusal({"replay", recording}, 1, "a.json, events[0].load_paint: \"#12\" is not a colour");
}

TEST_F(CliPaints, KnowsThePigmentsOfTheUsersOwn) {
    write_pigment("Grandma", 36);
    EXPECT_THAT(output_of({"info", "paints"}),
                ContainsRegex("Your own:\n +Grandma .*Grandmother's blue"));
    EXPECT_THAT(output_of({"info", "paint", "Grandma"}), HasSubstr("Grandma: Grandmother's blue\n"));
}

TEST_F(CliPaints, AUsersFileWithAFaultKeepsNobodyFromTheOtherPaints) {
    write_pigment("Grandma", 12);
    const std::string fault =
        "mine.csv, line 2: column 16 (500): missing; there are 15 columns instead of 39.";
    const RunResult list = run_cli({"info", "paints"});
    EXPECT_EQ(list.status, 1);
    EXPECT_THAT(list.output, HasSubstr("Ultramarine blue"));
    EXPECT_THAT(list.errors, HasSubstr(fault));
    EXPECT_THAT(output_of({"info", "paint", "PB29"}), HasSubstr("PB29: Ultramarine blue\n"));
    const RunResult missing = run_cli({"info", "paint", "Grandma"});
    EXPECT_THAT(missing.errors, HasSubstr("Not read: "));
    EXPECT_THAT(missing.errors, HasSubstr(fault));
}

}  // namespace
}  // namespace pastoso::cli
