// Commands found by a few letters.
#include "commands/command_search.hpp"

#include "commands/command_words.hpp"

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>

namespace pastoso::commands {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

Command first_of(const char* typed) {
    const std::vector<Command> found = find_commands(QString::fromUtf8(typed));
    EXPECT_FALSE(found.empty()) << typed;
    return found.empty() ? Command::Quit : found.front();
}

TEST(CommandSearch, EveryCommandHasWordsAHintAndIsFoundByThem) {
    for (const CommandText& text : command_list()) {
        const QString words = plain_words(text.words);
        EXPECT_FALSE(words.isEmpty());
        EXPECT_FALSE(words.contains(QLatin1Char('&')));
        EXPECT_FALSE(plain_words(text.menu).isEmpty()) << text.words;
        EXPECT_GT(QString::fromUtf8(text.hint).size(), 3) << text.words;
        EXPECT_THAT(find_commands(words), Contains(text.command)) << text.words;
    }
}

TEST(CommandSearch, BeginningsOfWordsAreEnough) {
    EXPECT_EQ(first_of("dry"), Command::DryNow);
    EXPECT_EQ(first_of("dr"), Command::DryNow);
    EXPECT_EQ(first_of("NEW LAY"), Command::AddLayer);
    EXPECT_EQ(first_of("lay new"), Command::AddLayer);
    EXPECT_EQ(first_of("  mirror left "), Command::MirrorSymmetry);
    EXPECT_EQ(first_of("mixing w"), Command::MixingWell);
}

TEST(CommandSearch, BeginningsMayBeTypedInOneWord) {
    EXPECT_EQ(first_of("nl"), Command::AddLayer);
    EXPECT_EQ(first_of("newlay"), Command::AddLayer);
    EXPECT_THAT(find_commands("ln"), Not(Contains(Command::AddLayer)));
}

TEST(CommandSearch, FindsWhatOtherProgramsCallOtherwise) {
    for (const char* typed : {"adjust", "hue", "colour adjustment", "glaze"})
        EXPECT_THAT(find_commands(QString::fromUtf8(typed)), Contains(Command::AdjustDryPaint)) << typed;
    for (const auto& [typed, command] : {std::pair("select opaque", Command::SelectPaint),
                                         {"alpha lock", Command::LockBare},
                                         {"clipping", Command::ClipLayer},
                                         {"clipping mask", Command::ClipLayer},
                                         {"assistant", Command::Ruler},
                                         {"incremental", Command::SaveVersion},
                                         {"save incremental", Command::SaveVersion},
                                         {"wand", Command::SelectContiguous},
                                         {"frisket", Command::MaskingFluid},
                                         {"resize canvas", Command::CanvasSize},
                                         {"trim to selection", Command::CropToSelection},
                                         {"deselect", Command::SelectEverything},
                                         {"eyedropper", Command::PickPaint},
                                         {"bucket", Command::FillPaint},
                                         {"magic", Command::SelectContiguous}})
        EXPECT_EQ(first_of(typed), command) << typed;
    EXPECT_THAT(find_commands("frisket zebra"), IsEmpty());
}

TEST(CommandSearch, WhatItIsCalledElsewhereComesAfterOwnWords) {
    const std::vector<Command> found = find_commands("canvas");
    const auto place = [&](Command command) {
        return std::find(found.begin(), found.end(), command) - found.begin();
    };
    ASSERT_THAT(found, Contains(Command::MirrorView));
    EXPECT_LT(place(Command::CanvasSize), place(Command::MirrorView));
    EXPECT_LT(place(Command::FitCanvas), place(Command::MirrorView));
    EXPECT_LT(place(Command::MirrorView), place(Command::TurnLeft)) << "by its hint alone";
    EXPECT_GT(fit_of_name("gpl", "Save the palette", "Colour panel", "swatches, gpl"), 0);
    EXPECT_GT(fit_of_name("save", "Save the palette", "Colour panel"),
              fit_of_name("gpl", "Save the palette", "Colour panel", "gpl"));
    EXPECT_EQ(fit_of_name("gpl", "Save the palette", "Colour panel"), 0);
}

TEST(CommandSearch, TheMiddleOfAWordFindsNothing) {
    EXPECT_THAT(find_commands("ayer"), IsEmpty());
    EXPECT_THAT(find_commands("new zebra"), IsEmpty());
    EXPECT_THAT(find_commands(""), IsEmpty());
    EXPECT_THAT(find_commands(" ..."), IsEmpty());
}

TEST(CommandSearch, OwnWordsComeBeforeMenuAndHint) {
    const std::vector<Command> found = find_commands("light");
    const auto place = [&](Command command) {
        return std::find(found.begin(), found.end(), command) - found.begin();
    };
    EXPECT_EQ(found.front(), Command::LightPanel);
    EXPECT_LT(place(Command::LightA), place(Command::LightD65));  // by its menu
    EXPECT_LT(place(Command::LightA), place(Command::LightLed));  // by its menu
    ASSERT_THAT(found, Contains(Command::LightD50));
    EXPECT_THAT(find_commands("stirring"), Contains(Command::DryNow));  // by its hint
}

}  // namespace
}  // namespace pastoso::commands
