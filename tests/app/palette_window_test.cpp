// The list of commands that a few letters search, by real keys.
#include "app/window_fixture.hpp"
#include "dialogs/command_delegate.hpp"
#include "dialogs/command_palette.hpp"

#include <utility>
#include <vector>

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QSignalSpy>
#include <QTest>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using dialogs::CommandDelegate;

class PaletteWindow : public WindowTest {
  protected:
    dialogs::CommandPalette& palette() { return *window().findChild<dialogs::CommandPalette*>(); }
    QListView& list() { return *palette().findChild<QListView*>(); }

    /// As the windowing system delivers them: to the window, which hands them to what is open over it.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(window().windowHandle(), key, modifiers);
        QApplication::processEvents();
    }
    void type(const char* letters) {
        for (const char* letter = letters; *letter != 0; ++letter)
            QTest::keyClick(window().windowHandle(), *letter);
        QApplication::processEvents();
    }
    void open() {
        canvas().setFocus();
        key(Qt::Key_Return, Qt::ControlModifier);
        ASSERT_TRUE(palette().isVisible());
    }
    Command command_at(int row) {
        return static_cast<Command>(
            list().model()->index(row, 0).data(CommandDelegate::kCommand).toInt());
    }
    int row_of(Command command) {
        for (int row = 0; row < list().model()->rowCount(); ++row)
            if (command_at(row) == command) return row;
        return -1;
    }
    std::size_t layers() {
        settle();
        return session().snapshot()->layers->layers.size();
    }
};

TEST_F(PaletteWindow, AFewLettersAndEnterGiveACommand) {
    const std::size_t before = layers();
    open();
    type("new lay");
    EXPECT_EQ(command_at(0), Command::AddLayer);
    key(Qt::Key_Return);
    EXPECT_FALSE(palette().isVisible());
    EXPECT_EQ(layers(), before + 1);
}

TEST_F(PaletteWindow, FindsToolsPaintsAndMedia) {
    const auto take = [this](const char* name) {
        open();
        type(name);
        key(Qt::Key_Return);
        EXPECT_FALSE(palette().isVisible());
    };
    take("fan 26");
    EXPECT_EQ(studio().easel().hand().brush, "Fan 26");
    const document::PaintRecipe paint = studio().easel().hand().paint;
    take("titanium w");
    EXPECT_FALSE(studio().easel().hand().paint == paint);
    take("stand oil");
    EXPECT_EQ(studio().easel().hand().medium.name, "stand oil");
}

TEST_F(PaletteWindow, FindsControlsAndGivesThemTheKeyboard) {
    for (const auto& [typed, name] : {std::pair("harmony", "harmony"),
                                      {"gamut mask", "mask_shape"},
                                      {"tube sets", "tube_sets"},
                                      {"tags of", "brush_folder"},
                                      {"snapping str", "guide_strength"}}) {
        open();
        type(typed);
        key(Qt::Key_Return);
        QTest::qWait(0);
        auto* control = window().findChild<QWidget*>(QLatin1String(name));
        ASSERT_NE(control, nullptr) << name;
        EXPECT_TRUE(control->isVisible()) << name;
        EXPECT_EQ(window().focusWidget(), control) << name;
    }
}

TEST_F(PaletteWindow, WhatIsGreyInAPanelStandsBelowAndCannotBeTaken) {
    open();
    type("gpl");
    ASSERT_EQ(list().model()->rowCount(), 2);
    EXPECT_EQ(list().model()->index(0, 0).data().toString(), "Open a palette");
    const QModelIndex save = list().model()->index(1, 0);
    EXPECT_EQ(save.data().toString(), "Save the palette");
    EXPECT_FALSE(save.flags().testFlag(Qt::ItemIsEnabled)) << "there is nothing on it yet";
    key(Qt::Key_Escape);
}

TEST_F(PaletteWindow, AMixIsKeptAndFoundByItsName) {
    const document::PaintRecipe sky{{{"PB29", 1.0}, {"PW6", 8.0}}, 0.5};
    studio().choose_paint(sky);
    open();
    type("keep as a mix");
    key(Qt::Key_Return);
    QTest::qWait(0);
    auto* mixes = window().findChild<QListWidget*>(QStringLiteral("mixes"));
    ASSERT_EQ(mixes->count(), 1);
    auto* editor = mixes->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr) << "it asks for a name";
    editor->selectAll();
    QTest::keyClicks(editor, "my sky");
    QTest::keyClick(editor, Qt::Key_Return);
    QApplication::processEvents();
    studio().choose_paint({{{"PR108", 1.0}}, 1.0});
    open();
    type("my sky");
    EXPECT_EQ(list().model()->index(0, 0).data(CommandDelegate::kMenu).toString(), "Your mix");
    key(Qt::Key_Return);
    EXPECT_EQ(studio().easel().hand().paint, sky);
}

TEST_F(PaletteWindow, FindsWhatTheMenuOfTheTubesDoes) {
    open();
    type("squeeze out the last");
    key(Qt::Key_Return);
    EXPECT_EQ(told(), "No paint was squeezed out beside an earlier painting yet.");
}

TEST_F(PaletteWindow, HoldsEveryCommandWithItsMenuAndKeys) {
    open();
    EXPECT_EQ(list().model()->rowCount(), static_cast<int>(commands::command_list().size()));
    for (const commands::CommandText& text : commands::command_list()) {
        const int row = row_of(text.command);
        ASSERT_GE(row, 0) << text.words;
        const QModelIndex index = list().model()->index(row, 0);
        EXPECT_FALSE(index.data().toString().isEmpty());
        EXPECT_FALSE(index.data(CommandDelegate::kMenu).toString().isEmpty()) << text.words;
        EXPECT_FALSE(index.data(CommandDelegate::kHint).toString().isEmpty()) << text.words;
    }
    const QModelIndex undo = list().model()->index(row_of(Command::Undo), 0);
    EXPECT_EQ(undo.data(CommandDelegate::kMenu).toString(), "Edit");
    EXPECT_EQ(undo.data(CommandDelegate::kKeys).toString(), "Ctrl+Z");
}

TEST_F(PaletteWindow, WhatCannotBeDoneNowIsFaintAndNotDone) {
    ASSERT_FALSE(action(Command::Redo)->isEnabled());
    const QSignalSpy given(action(Command::Redo), &QAction::triggered);
    open();
    type("redo");
    ASSERT_EQ(command_at(0), Command::Redo);
    EXPECT_FALSE(list().model()->index(0, 0).flags().testFlag(Qt::ItemIsEnabled));
    key(Qt::Key_Return);
    EXPECT_TRUE(palette().isVisible());
    EXPECT_EQ(given.count(), 0);
}

TEST_F(PaletteWindow, ArrowsChooseAndTheLatestComesFirstNextTime) {
    open();
    type("zoom");
    ASSERT_EQ(command_at(0), Command::ZoomIn);
    ASSERT_EQ(command_at(1), Command::ZoomOut);
    key(Qt::Key_Down);
    key(Qt::Key_Up);
    key(Qt::Key_Down);
    const double zoom = canvas().view_transform().zoom;
    key(Qt::Key_Return);
    EXPECT_LT(canvas().view_transform().zoom, zoom);
    open();
    EXPECT_EQ(command_at(0), Command::ZoomOut);
    key(Qt::Key_Return);
    EXPECT_LT(canvas().view_transform().zoom, zoom / 1.5);
}

TEST_F(PaletteWindow, EscapeClosesItAndKeysGoToTheCanvasAgain) {
    open();
    type("dry");
    key(Qt::Key_Escape);
    EXPECT_FALSE(palette().isVisible());
    const double width_mm = studio().easel().hand().brush_width_mm;
    key(Qt::Key_BracketRight);
    EXPECT_GT(studio().easel().hand().brush_width_mm, width_mm);
    open();
    EXPECT_TRUE(palette().findChild<QLineEdit*>()->text().isEmpty());
}

TEST_F(PaletteWindow, NothingFoundIsSaid) {
    open();
    type("zzz");
    EXPECT_EQ(list().model()->rowCount(), 0);
    EXPECT_TRUE(palette().findChild<QLabel*>("reading")->text().startsWith("Nothing of that name"));
    key(Qt::Key_Down);
    key(Qt::Key_Return);
    EXPECT_TRUE(palette().isVisible());
}

TEST_F(PaletteWindow, AClickGivesACommand) {
    const std::size_t before = layers();
    open();
    type("new layer");
    const QRect row = list().visualRect(list().model()->index(0, 0));
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, row.center());
    QApplication::processEvents();
    EXPECT_FALSE(palette().isVisible());
    EXPECT_EQ(layers(), before + 1);
}

TEST_F(PaletteWindow, WhatWasGivenLastComesFirstAfterTheNextStartToo) {
    open();
    type("actual pix");
    key(Qt::Key_Return);
    action(Command::FitCanvas)->trigger();
    const std::vector<Command> given = studio().commands().recent();
    ASSERT_EQ(given.front(), Command::FitCanvas);
    ASSERT_EQ(given[1], Command::ActualPixels);
    start_again();
    const std::vector<Command>& recalled = studio().commands().recent();
    ASSERT_GE(recalled.size(), 2U);
    EXPECT_EQ(recalled[0], given[0]);
    EXPECT_EQ(recalled[1], given[1]);
    open();
    EXPECT_EQ(command_at(0), Command::FitCanvas);
}

}  // namespace
}  // namespace pastoso::tests
