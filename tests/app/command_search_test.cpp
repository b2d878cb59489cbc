// Commands found by a few letters.
#include "commands/command_search.hpp"

#include "commands/command_words.hpp"

#include <algorithm>

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
