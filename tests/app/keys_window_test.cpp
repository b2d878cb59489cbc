// Keys changed by the painter, by real keys, and found again at the next start.
#include "app/window_fixture.hpp"
#include "core/text_file.hpp"
#include "dialogs/key_catcher.hpp"
#include "dialogs/keys_dialog.hpp"

#include <functional>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class KeysWindow : public WindowTest {
  protected:
    /// Opens the dialog by its key, does that in it, and closes it.
    void in_dialog(const std::function<void()>& what) {
        bool done = false;
        QTimer::singleShot(0, &window(), [&] {
            auto* open = qobject_cast<dialogs::KeysDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(open, nullptr);
            dialog_ = open;
            what();
            done = true;
            open->close();
        });
        QTest::keyClick(&canvas(), Qt::Key_K, Qt::ControlModifier | Qt::AltModifier);
        EXPECT_TRUE(done);
        QApplication::processEvents();
    }
    template <class Widget>
    Widget& part(const char* name) {
        return *dialog_->findChild<Widget*>(QString::fromUtf8(name));
    }
    std::string sentence() { return part<QLabel>("sentence").text().toStdString(); }
    void find(const char* words) {
        auto& line = part<QLineEdit>("typed");
        line.clear();
        QTest::keyClicks(&line, words);
    }
    void catch_key(dialogs::KeyCatcher& button, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&button, Qt::LeftButton);
        ASSERT_TRUE(button.listening());
        QTest::keyClick(&button, key, modifiers);
    }
    void add_key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        catch_key(part<dialogs::KeyCatcher>("add_key"), key, modifiers);
    }
    void click(const char* name) { QTest::mouseClick(&part<QPushButton>(name), Qt::LeftButton); }
    std::string keys_of(Command command) {
        return QKeySequence::listToString(action(command)->shortcuts()).toStdString();
    }
    std::filesystem::path file() const { return settings_file().parent_path() / "keys.json"; }

    dialogs::KeysDialog* dialog_ = nullptr;
};

TEST_F(KeysWindow, AnotherKeyGivesTheCommandAtOnceAndAtTheNextStart) {
    in_dialog([&] {
        find("pause the paint");
        add_key(Qt::Key_F12, Qt::ShiftModifier);
        EXPECT_EQ(keys_of(Command::Pause), "F; Shift+F12");
    });
    QSignalSpy given(action(Command::Pause), &QAction::triggered);
    QTest::keyClick(&canvas(), Qt::Key_F12, Qt::ShiftModifier);
    QTest::keyClick(&canvas(), Qt::Key_F);
    EXPECT_EQ(given.count(), 2);
    start_again();
    EXPECT_EQ(keys_of(Command::Pause), "F; Shift+F12");
    EXPECT_TRUE(action(Command::Pause)->toolTip().endsWith("(F)"));
}

TEST_F(KeysWindow, AKeyOfAnotherCommandIsAskedFor) {
    in_dialog([&] {
        find("dry now");
        add_key(Qt::Key_J, Qt::ControlModifier);
        EXPECT_THAT(sentence(), HasSubstr("Ctrl+J is the key of \"Layer › Duplicate\""));
        click("leave");
        EXPECT_EQ(sentence(), "");
        EXPECT_EQ(keys_of(Command::DryNow), "D");
        add_key(Qt::Key_J, Qt::ControlModifier);
        click("take");
    });
    EXPECT_EQ(keys_of(Command::DryNow), "D; Ctrl+J");
    EXPECT_EQ(keys_of(Command::DuplicateLayer), "");
    QSignalSpy given(action(Command::DryNow), &QAction::triggered);
    QTest::keyClick(&canvas(), Qt::Key_J, Qt::ControlModifier);
    EXPECT_EQ(given.count(), 1);
    in_dialog([&] {
        find("dry now");
        click("reset_one");
    });
    EXPECT_EQ(keys_of(Command::DryNow), "D");
    EXPECT_EQ(keys_of(Command::DuplicateLayer), "Ctrl+J");
}

TEST_F(KeysWindow, KeysAreExchangedAndTakenAway) {
    in_dialog([&] {
        find("redo");
        QTest::mouseClick(&part<QToolButton>("drop Ctrl+Y"), Qt::LeftButton);
        EXPECT_EQ(keys_of(Command::Redo), "Ctrl+Shift+Z");
        QApplication::processEvents();  // the keys that are left are shown anew
        auto& tree = part<QTreeWidget>("commands");
        QTreeWidgetItem* row = tree.currentItem();
        ASSERT_EQ(row->text(0), "Redo");
        QTest::mouseClick(tree.viewport(), Qt::LeftButton, {},
                          tree.visualRect(tree.indexFromItem(row, 1)).center());
        auto* listening = qobject_cast<dialogs::KeyCatcher*>(dialog_->focusWidget());
        ASSERT_NE(listening, nullptr);
        ASSERT_TRUE(listening->listening());
        QTest::keyClick(listening, Qt::Key_F12);
    });
    EXPECT_EQ(keys_of(Command::Redo), "F12");
}

TEST_F(KeysWindow, EscapeCatchesNothingAndKeysOfTheCanvasAreRefused) {
    in_dialog([&] {
        find("dry now");
        add_key(Qt::Key_Escape);
        EXPECT_TRUE(dialog_->isVisible());
        EXPECT_EQ(keys_of(Command::DryNow), "D");
        add_key(Qt::Key_Space);
        EXPECT_THAT(sentence(), HasSubstr("needed on the canvas"));
        EXPECT_EQ(keys_of(Command::DryNow), "D");
        add_key(Qt::Key_D);
        EXPECT_THAT(sentence(), HasSubstr("its key already"));
    });
    EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(KeysWindow, ASetIsChosenAndTheOwnStay) {
    in_dialog([&] {
        find("dry now");
        add_key(Qt::Key_V);
        auto& sets = part<QComboBox>("sets");
        sets.setFocus();
        QTest::keyClick(&sets, Qt::Key_Down);
        EXPECT_EQ(sets.currentText(), "Like Krita");
        EXPECT_EQ(keys_of(Command::SelectEllipse), "J; Shift+A");
        QTest::keyClick(&sets, Qt::Key_Down);
        EXPECT_EQ(sets.currentText(), "Like Photoshop");
    });
    EXPECT_EQ(keys_of(Command::DryNow), "D; V");
    EXPECT_EQ(keys_of(Command::TransformLayer), "Ctrl+T");
    EXPECT_FALSE(action(Command::SelectRectangle)->isChecked());
    QTest::keyClick(&canvas(), Qt::Key_M);
    EXPECT_TRUE(action(Command::SelectRectangle)->isChecked());
    open_another();
    EXPECT_EQ(studio().commands().keys().set(), commands::KeySet::Photoshop);
    in_dialog([&] {
        click("reset_all");
        EXPECT_THAT(sentence(), HasSubstr("All keys"));
        click("take");
    });
    EXPECT_EQ(keys_of(Command::DryNow), "D");
    EXPECT_EQ(keys_of(Command::TransformLayer), "Ctrl+T; V");
}

TEST_F(KeysWindow, CommandsAreFoundByWordsAndByKeys) {
    in_dialog([&] {
        auto& tree = part<QTreeWidget>("commands");
        find("ctrl+j");
        EXPECT_EQ(tree.currentItem()->text(0), "Duplicate");
        find("mixing");
        EXPECT_EQ(tree.currentItem()->text(0), "Mixing well");
        int shown = 0;
        for (int menu = 0; menu < tree.topLevelItemCount(); ++menu)
            shown += tree.topLevelItem(menu)->isHidden() ? 0 : 1;
        const QTreeWidgetItem& none = *tree.topLevelItem(tree.topLevelItemCount() - 1);
        EXPECT_LT(shown, tree.topLevelItemCount() - 1) << "besides what says that nothing is found";
        EXPECT_TRUE(none.isHidden());
        find("xyzzy");
        EXPECT_FALSE(none.isHidden());
        EXPECT_FALSE(none.text(0).isEmpty());
        for (int menu = 0; menu < tree.topLevelItemCount() - 1; ++menu)
            EXPECT_TRUE(tree.topLevelItem(menu)->isHidden());
    });
}

TEST_F(KeysWindow, AFileThatCannotBeReadIsToldAndLeftAlone) {
    const std::string text =
        R"({"version": 1, "set": "krita", "own": [{"command": "quit", "keys": ["Hyperspace"]}]})";
    std::filesystem::create_directories(file().parent_path());
    core::write_text_file(file(), text);
    open_another();
    EXPECT_THAT(told(), HasSubstr("own[0].keys[0]: \"Hyperspace\" is not a key"));
    in_dialog([&] {
        find("dry now");
        add_key(Qt::Key_F12);
    });
    EXPECT_EQ(keys_of(Command::DryNow), "D; F12");
    EXPECT_EQ(core::read_text_file(file()), text);
}

TEST_F(KeysWindow, WhatALaterVersionKeptThereStays) {
    std::filesystem::create_directories(file().parent_path());
    core::write_text_file(file(), R"({"version": 1, "set": "photoshop", "own":
                                      [{"command": "paint_the_ceiling", "keys": ["F12"]}]})");
    open_another();
    in_dialog([&] {
        find("dry now");
        add_key(Qt::Key_F13);
    });
    EXPECT_THAT(core::read_text_file(file()), HasSubstr("paint_the_ceiling"));
    EXPECT_THAT(core::read_text_file(file()), HasSubstr("dry_now"));
}

}  // namespace
}  // namespace pastoso::tests
