// Sets of keys, and the painter's own over them.
#include "commands/key_bindings.hpp"

#include "commands/command_names.hpp"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace pastoso::commands {
namespace {

using Keys = KeyBindings::Keys;

Keys keys(const char* text) {
    return QKeySequence::listFromString(QString::fromUtf8(text));
}

/// Every key of every command of a mode, with the command that has it; fails the test where two have
/// one.
std::map<std::string, Command> holders(const KeyBindings& bindings, Mode mode) {
    std::map<std::string, Command> found;
    for (const CommandText& text : command_list()) {
        if (!meet(text.mode, mode)) continue;
        for (const QKeySequence& key : bindings.keys(text.command)) {
            const std::string name = key.toString().toStdString();
            const auto [before, is_free] = found.try_emplace(name, text.command);
            EXPECT_TRUE(is_free) << name << ": " << name_of(before->second) << " and "
                                 << name_of(text.command);
        }
    }
    return found;
}

std::map<std::string, Command> holders(const KeyBindings& bindings) {
    holders(bindings, Mode::Tea);
    holders(bindings, Mode::Tank);
    return holders(bindings, Mode::Painting);
}

TEST(KeySets, GiveNoKeyToTwoCommands) {
    for (const KeySetText& set : key_sets()) {
        SCOPED_TRACE(set.name);
        EXPECT_GT(holders(KeyBindings(set.set)).size(), 60u);
    }
}

TEST(KeySets, HoldNothingButKeysThatCanBeGiven) {
    for (const KeySetText& set : key_sets())
        for (const CommandText& text : command_list())
            for (const QKeySequence& key : keys_in(set.set, text.command)) {
                EXPECT_EQ(key.count(), 1) << name_of(text.command);
                EXPECT_NE(key[0].key(), Qt::Key_unknown) << name_of(text.command);
                EXPECT_FALSE(is_reserved(key)) << name_of(text.command);
            }
}

TEST(KeySets, AreWhatHandsKnow) {
    const KeyBindings ours, krita(KeySet::Krita), photoshop(KeySet::Photoshop);
    for (const KeyBindings* each : {&ours, &krita, &photoshop}) {
        EXPECT_EQ(each->holder(QKeySequence("B")), Command::NextBrush);
        EXPECT_EQ(each->holder(QKeySequence("[")), Command::SmallerBrush);
        EXPECT_EQ(each->holder(QKeySequence("X")), Command::SwapPaints);
        EXPECT_EQ(each->holder(QKeySequence("Ctrl+T")), Command::TransformLayer);
        EXPECT_EQ(each->holder(QKeySequence("Ctrl+J")), Command::DuplicateLayer);
        EXPECT_EQ(each->holder(QKeySequence("Ctrl+E")), Command::MergeDown);
        EXPECT_EQ(each->holder(QKeySequence("Ctrl+Return")), Command::FindCommand);
    }
    EXPECT_EQ(krita.holder(QKeySequence("Ins")), Command::AddLayer);
    EXPECT_EQ(krita.holder(QKeySequence("PgUp")), Command::LayerAbove);
    EXPECT_EQ(krita.holder(QKeySequence("P")), Command::PickPaint);
    EXPECT_EQ(krita.holder(QKeySequence("T")), Command::TransformLayer);
    EXPECT_EQ(krita.holder(QKeySequence("Ctrl+R")), Command::SelectRectangle);
    EXPECT_EQ(krita.holder(QKeySequence("J")), Command::SelectEllipse);
    EXPECT_EQ(krita.holder(QKeySequence("G")), Command::FillGradient);
    EXPECT_EQ(krita.holder(QKeySequence("Ctrl+Shift+G")), Command::ClipLayer);
    EXPECT_EQ(photoshop.holder(QKeySequence("I")), Command::PickPaint);
    EXPECT_EQ(photoshop.holder(QKeySequence("V")), Command::TransformLayer);
    EXPECT_EQ(photoshop.holder(QKeySequence("M")), Command::SelectRectangle);
    EXPECT_EQ(photoshop.holder(QKeySequence("Ctrl+D")), Command::SelectEverything);
}

/// What has a key in ours has one like Krita, too: it has moved, and is not lost.
TEST(KeySets, LikeKritaTakesNoKeyWithoutAnother) {
    const KeyBindings ours, krita(KeySet::Krita);
    for (const CommandText& text : command_list())
        EXPECT_GE(krita.keys(text.command).size(), ours.keys(text.command).size())
            << name_of(text.command);
    EXPECT_EQ(ours.holder(QKeySequence("Ctrl+R")), Command::TopUpBrush);
    EXPECT_EQ(ours.holder(QKeySequence("A")), krita.holder(QKeySequence("A")));
}

TEST(CommandNames, AreEachOfOneCommand) {
    std::set<std::string_view> names;
    for (const CommandText& text : command_list()) {
        EXPECT_TRUE(names.insert(name_of(text.command)).second) << name_of(text.command);
        EXPECT_EQ(command_named(name_of(text.command)), text.command);
    }
    EXPECT_EQ(command_named("tea_pause"), Command::LiquidPause)
        << "keys of before are the painter's still";
    EXPECT_EQ(command_named("paint_the_ceiling"), std::nullopt);
}

TEST(KeyBindings, TheOwnLieOverTheSet) {
    KeyBindings bindings;
    bindings.give(Command::DryNow, keys("Ctrl+J; D"));
    EXPECT_EQ(bindings.keys(Command::DryNow), keys("Ctrl+J; D"));
    EXPECT_EQ(bindings.keys(Command::DuplicateLayer), Keys());
    EXPECT_EQ(bindings.holder(QKeySequence("Ctrl+J")), Command::DryNow);
    EXPECT_FALSE(bindings.is_own(Command::DuplicateLayer));
    bindings.choose(KeySet::Photoshop);
    EXPECT_EQ(bindings.holder(QKeySequence("Ctrl+J")), Command::DryNow);
    EXPECT_EQ(bindings.holder(QKeySequence("V")), Command::TransformLayer);
    holders(bindings);
}

TEST(KeyBindings, WhatIsTakenFromTheSetComesBackWithReset) {
    KeyBindings bindings;
    bindings.give(Command::DryNow, keys("Ctrl+J"));
    bindings.reset(Command::DryNow);
    EXPECT_EQ(bindings, KeyBindings());
    EXPECT_EQ(bindings.holder(QKeySequence("Ctrl+J")), Command::DuplicateLayer);
    EXPECT_EQ(bindings.holder(QKeySequence("D")), Command::DryNow);
}

TEST(KeyBindings, AKeyIsTakenFromTheOwnOfAnother) {
    KeyBindings bindings;
    bindings.give(Command::DryNow, keys("F11; F12"));
    bindings.give(Command::Pause, keys("F12"));
    EXPECT_EQ(bindings.keys(Command::DryNow), keys("F11"));
    EXPECT_EQ(bindings.keys(Command::Pause), keys("F12"));
    // A set's key that another command got is not given back to two.
    bindings.give(Command::FitCanvas, keys("D"));
    bindings.reset(Command::DryNow);
    EXPECT_EQ(bindings.keys(Command::DryNow), Keys());
    holders(bindings);
}

TEST(KeyBindings, OneKeyMayMeanSomethingElseInAnotherMode) {
    KeyBindings bindings;
    EXPECT_EQ(bindings.holder(QKeySequence("F4"), Mode::Painting), Command::LightPanel);
    EXPECT_EQ(bindings.holder(QKeySequence("F4"), Mode::Tea), Command::LiquidPause);
    bindings.give(Command::TeaRender, keys("D; F4"));
    EXPECT_EQ(bindings.holder(QKeySequence("D"), Mode::Painting), Command::DryNow);
    EXPECT_EQ(bindings.holder(QKeySequence("F4"), Mode::Painting), Command::LightPanel);
    EXPECT_EQ(bindings.holder(QKeySequence("F4"), Mode::Tea), Command::TeaRender);
    EXPECT_EQ(bindings.keys(Command::LiquidPause), Keys());
    // What is given everywhere has its keys in both.
    bindings.give(Command::Quit, keys("D"));
    EXPECT_EQ(bindings.keys(Command::DryNow), Keys());
    EXPECT_EQ(bindings.keys(Command::TeaRender), keys("F4"));
    holders(bindings);
}

TEST(KeyBindings, ACommandMayHaveNoKey) {
    KeyBindings bindings;
    bindings.give(Command::Quit, {});
    EXPECT_EQ(bindings.keys(Command::Quit), Keys());
    EXPECT_TRUE(bindings.is_own(Command::Quit));
    EXPECT_EQ(bindings.holder(QKeySequence("Ctrl+Q")), std::nullopt);
}

TEST(KeyBindings, TheKeysOfTheSetGivenAgainAreNoOwn) {
    KeyBindings bindings;
    bindings.give(Command::Quit, {});
    bindings.give(Command::Quit, keys("Ctrl+Q"));
    EXPECT_EQ(bindings, KeyBindings());
}

TEST(KeyBindings, KeysOfTheCanvasAreReserved) {
    for (const char* key : {"Space", "Shift+Space", "Esc", "Return", "Enter"})
        EXPECT_TRUE(is_reserved(QKeySequence(key))) << key;
    for (const char* key : {"Ctrl+Return", "Tab", "S", "F1"})
        EXPECT_FALSE(is_reserved(QKeySequence(key))) << key;
}

}  // namespace
}  // namespace pastoso::commands
