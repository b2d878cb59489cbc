// All of the window can be reached with the keyboard alone, nothing holds it fast, and one sees where it
// is.
#include "app/window_fixture.hpp"
#include "appearance/theme.hpp"
#include "commands/key_bindings.hpp"
#include "core/units.hpp"
#include "dialogs/adjust_dialog.hpp"
#include "dialogs/canvas_size_dialog.hpp"
#include "dialogs/crash_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/keys_dialog.hpp"
#include "dialogs/length_dialog.hpp"
#include "dialogs/new_canvas_dialog.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "dialogs/select_range_dialog.hpp"
#include "dialogs/settings_dialog.hpp"
#include "dialogs/texture_dialog.hpp"
#include "dialogs/transform_dialog.hpp"
#include "main/window_parts.hpp"
#include "panels/canvas/direction_dial.hpp"
#include "panels/canvas/navigator_map.hpp"
#include "panels/canvas/tilt_dial.hpp"
#include "panels/colour/colour_wheel.hpp"
#include "panels/colour/picture_board.hpp"
#include "panels/layers/layer_tree.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/paint/tube_menu.hpp"
#include "panels/pen/brush_list.hpp"
#include "panels/pen/brush_panel.hpp"
#include "panels/pen/curve_editor.hpp"
#include "panels/pen/pen_dialog.hpp"
#include "panels/references/reference_view.hpp"
#include "start/start_page.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QEnterEvent>
#include <QInputDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>
#include <QTimer>

namespace pastoso::tests {
namespace {

using commands::Command;

template <class... Kinds>
bool is_one_of(const QWidget& widget) {
    return ((qobject_cast<const Kinds*>(&widget) != nullptr) || ...);
}

/// The lines of spin boxes, the buttons of docks and the like: their owners have the keyboard.
bool is_part_of_control(const QWidget& widget) {
    const QWidget* owner = widget.parentWidget();
    if (owner != nullptr && is_one_of<QTabBar, QDockWidget, QLineEdit>(*owner)) return true;
    for (; owner != nullptr && !owner->isWindow(); owner = owner->parentWidget())
        if (is_one_of<QAbstractSpinBox, QComboBox, QAbstractItemView>(*owner)) return true;
    return false;
}

/// What a painter works with. The tabs of docks are left to the keys of the panels.
bool is_control(const QWidget& widget) {
    if (!widget.isVisible() || !widget.isEnabled() || is_part_of_control(widget)) return false;
    if (is_one_of<QScrollBar>(widget)) return false;
    if (is_one_of<QTabBar>(widget)) return !is_one_of<QMainWindow>(*widget.parentWidget());
    return is_one_of<QAbstractButton, QAbstractSpinBox, QComboBox, QLineEdit, QAbstractSlider,
                     QAbstractItemView, QPlainTextEdit, panels::DirectionDial, panels::CurveEditor,
                     panels::ColourWheel, panels::NavigatorMap, panels::PictureBoard,
                     panels::ReferenceView>(widget);
}

std::string words_for(const QWidget& widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return std::string(widget.metaObject()->className()) + " " + widget.objectName().toStdString() +
           " " + (button != nullptr ? button->text() : widget.accessibleName()).toStdString() + " in " +
           (widget.parentWidget() != nullptr ? widget.parentWidget()->objectName().toStdString() : "");
}

/// Arrow keys reach the others of a group of which one is chosen.
bool shares_keys(const QWidget& control, const std::set<const QWidget*>& reached) {
    const auto* button = qobject_cast<const QAbstractButton*>(&control);
    if (button == nullptr || !button->isCheckable()) return false;
    const bool grouped = button->group() != nullptr && button->group()->exclusive();
    if (!grouped && !button->autoExclusive()) return false;
    return std::any_of(reached.begin(), reached.end(), [button](const QWidget* other) {
        const auto* one = qobject_cast<const QAbstractButton*>(other);
        return one != nullptr && one->parentWidget() == button->parentWidget() &&
               one->group() == button->group() && one->isCheckable();
    });
}

class Keyboard : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::Pause)->trigger();
        settle();
    }

    void open(QWidget& dialog) {
        dialog.show();
        wait_until_shown(dialog);
        QApplication::setActiveWindow(&dialog);
        QApplication::processEvents();
        // From its first key on a window shows what has the keyboard.
        for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab})
            QTest::keyClick(dialog.focusWidget() != nullptr ? dialog.focusWidget() : &dialog, key);
    }

    /// From what has the keyboard until that has it again, or `end` has; each once.
    std::set<const QWidget*> walk(Qt::Key key, const QWidget* end = nullptr) {
        constexpr int kMostSteps = 400;
        std::set<const QWidget*> reached;
        const QWidget* first = QApplication::focusWidget();
        for (int steps = 0; steps < kMostSteps; ++steps) {
            QWidget* here = QApplication::focusWidget();
            if (here == nullptr) {
                ADD_FAILURE() << "nothing has the keyboard";
                return reached;
            }
            if (here == end || (here == first && steps > 0)) return reached;
            reached.insert(here);
            const QImage with = here->grab().toImage();
            QTest::keyClick(here, key);
            if (QApplication::focusWidget() == here) {
                // The only one there is.
                if (steps > 0) ADD_FAILURE() << "the key does not leave " << words_for(*here);
                return reached;
            }
            if (is_control(*here) && with.size() == here->size() * here->devicePixelRatioF()) {
                EXPECT_NE(here->grab().toImage(), with)
                    << "not seen to be reached: " << words_for(*here);
            }
        }
        ADD_FAILURE() << "the way does not come back";
        return reached;
    }

    /// Of the widget and all in it.
    static void expect_all_in(QWidget& place, const std::set<const QWidget*>& reached) {
        int controls = 0;
        for (const QWidget* widget : place.findChildren<QWidget*>()) {
            if (widget->window() != place.window() || !is_control(*widget)) continue;
            ++controls;
            EXPECT_TRUE(reached.contains(widget) || shares_keys(*widget, reached))
                << "not reached: " << words_for(*widget);
        }
        EXPECT_GT(controls, 0);
    }

    void expect_all_reached(QWidget& dialog) {
        open(dialog);
        if (HasFatalFailure()) return;
        SCOPED_TRACE(dialog.windowTitle().toStdString());
        const auto forth = walk(Qt::Key_Tab);
        expect_all_in(dialog, forth);
        EXPECT_EQ(walk(Qt::Key_Backtab), forth);
    }
};

// ---- the window

TEST_F(Keyboard, ReachesEverythingAroundTheCanvas) {
    for (const appearance::Theme theme : {appearance::Theme::Dark, appearance::Theme::Light}) {
        SCOPED_TRACE(appearance::name_of(theme));
        appearance::apply_theme(*qApp, theme);
        QApplication::setActiveWindow(&window());
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_Backtab);
        ASSERT_FALSE(canvas().hasFocus());
        const auto back = walk(Qt::Key_Backtab, &canvas());
        expect_all_in(window(), back);
        canvas().nextInFocusChain()->setFocus(Qt::TabFocusReason);
    }
    appearance::apply_theme(*qApp, appearance::Theme::Dark);
}

TEST_F(Keyboard, APanelsCommandLeadsIntoItAndEscapeBackToTheCanvas) {
    QApplication::setActiveWindow(&window());
    for (const Command command :
         {Command::ToolPanel, Command::ColourPanel, Command::PhysicsPanel, Command::GuidesPanel,
          Command::LightPanel, Command::LayersPanel, Command::TracingPanel, Command::ReferencesPanel,
          Command::HistoryPanel, Command::NavigatorPanel, Command::RecorderPanel,
          Command::MessagesPanel}) {
        SCOPED_TRACE(action(command)->text().toStdString());
        canvas().setFocus();
        action(command)->trigger();
        QApplication::processEvents();
        QWidget* dock = QApplication::focusWidget();
        while (dock != nullptr && qobject_cast<QDockWidget*>(dock) == nullptr)
            dock = dock->parentWidget();
        ASSERT_NE(dock, nullptr);
        const QWidget* first = QApplication::focusWidget();
        EXPECT_TRUE(is_control(*first)) << words_for(*first);
        auto reached = walk(Qt::Key_Tab, &canvas());
        if (!QApplication::focusWidget()->isAncestorOf(first)) QApplication::processEvents();
        action(command)->trigger();
        reached.merge(walk(Qt::Key_Backtab, &canvas()));
        expect_all_in(*dock, reached);
        action(command)->trigger();
        ASSERT_FALSE(canvas().hasFocus());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        EXPECT_TRUE(canvas().hasFocus());
    }
}

TEST_F(Keyboard, ReachesAllOfTheStartPageAndLeavesIt) {
    parts().start.show_page();
    QApplication::setActiveWindow(&window());
    auto* page = window().findChild<start::StartPage*>();
    ASSERT_TRUE(page->isVisible());
    ASSERT_TRUE(page->isAncestorOf(QApplication::focusWidget()));
    auto reached = walk(Qt::Key_Tab, &canvas());
    parts().start.show_page();
    reached.merge(walk(Qt::Key_Backtab, &canvas()));
    expect_all_in(*page, reached);
    parts().start.show_page();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(page->isVisible());
}

// ---- what keys do there

TEST_F(Keyboard, ReturnTakesAToolAndAPaint) {
    QApplication::setActiveWindow(&window());
    const auto choose_next = [](QAbstractItemView& list) {
        list.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&list, Qt::Key_Down);
        QTest::keyClick(&list, Qt::Key_Return);
    };
    const std::string tool = studio().easel().hand().brush;
    choose_next(*window().findChild<panels::BrushList*>());
    EXPECT_NE(studio().easel().hand().brush, tool);
    const document::PaintRecipe paint = studio().easel().hand().paint;
    choose_next(*window().findChild<QListWidget*>(QStringLiteral("paints")));
    EXPECT_FALSE(studio().easel().hand().paint == paint);
}

TEST_F(Keyboard, AListThatIsClickedHasTheKeysUntilThePointerIsOverTheCanvas) {
    QApplication::setActiveWindow(&window());
    auto& brushes = *window().findChild<panels::BrushList*>();
    const auto click = [](QListWidget& list, int row) {
        list.scrollToItem(list.item(row));
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                          list.visualItemRect(list.item(row)).center());
    };
    const auto hand = [this]() -> const tools::Hand& { return studio().easel().hand(); };
    click(brushes, 3);
    ASSERT_TRUE(brushes.hasFocus());
    const std::string clicked = hand().brush;
    QTest::keyClick(&brushes, Qt::Key_Down);
    EXPECT_NE(hand().brush, clicked) << "an arrow takes the next tool";
    QTest::keyClick(&brushes, Qt::Key_D);
    EXPECT_TRUE(hand().brush.starts_with("D")) << hand().brush << ": nothing is dried, a name is found";
    EXPECT_TRUE(brushes.hasFocus());

    auto& paints = *window().findChild<QListWidget*>(QStringLiteral("paints"));
    click(paints, 0);
    ASSERT_TRUE(paints.hasFocus());
    const document::PaintRecipe paint = hand().paint;
    QTest::keyClick(&paints, Qt::Key_Down);
    EXPECT_FALSE(hand().paint == paint);

    const QPointF place = canvas().rect().center();
    QEnterEvent enter(place, place, canvas().mapToGlobal(place));
    QApplication::sendEvent(&canvas(), &enter);
    EXPECT_TRUE(canvas().hasFocus());
}

TEST_F(Keyboard, WhatRemovesAndRenamesIsForTheListThatHasTheKeys) {
    QApplication::setActiveWindow(&window());
    mouse_stroke(line_mm({10.0, 8.0}, {30.0, 8.0}));
    action(Command::HistoryPanel)->trigger();
    session().wait_until_applied();
    const std::int64_t changes = session().status().changes;
    ASSERT_GT(changes, 0);
    for (QAbstractItemView* list :
         {static_cast<QAbstractItemView*>(window().findChild<panels::BrushList*>()),
          window().findChild<QAbstractItemView*>(QStringLiteral("paints")),
          window().findChild<QAbstractItemView*>(QStringLiteral("history_list"))}) {
        list->setFocus(Qt::TabFocusReason);
        ASSERT_TRUE(list->hasFocus());
        for (const Qt::Key key : {Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F2})
            QTest::keyClick(list, key);
        session().wait_until_applied();
        EXPECT_EQ(session().status().changes, changes) << list->accessibleName().toStdString();
    }
    auto* layers = window().findChild<panels::LayerTree*>();
    EXPECT_EQ(layers->viewport()->findChild<QLineEdit*>(), nullptr) << "no layer is renamed";
    action(Command::LayersPanel)->trigger();
    QApplication::processEvents();
    ASSERT_TRUE(layers->hasFocus());
    QTest::keyClick(layers, Qt::Key_Backspace);
    session().wait_until_applied();
    EXPECT_EQ(session().status().changes, changes) << "no paint is poured";
    QTest::keyClick(layers, Qt::Key_Delete);
    session().wait_until_applied();
    EXPECT_GT(session().status().changes, changes) << "the chosen layer is cleared";
}

TEST_F(Keyboard, ArrowsTiltTheCanvas) {
    QApplication::setActiveWindow(&window());
    auto* dial = window().findChild<panels::TiltDial*>();
    dial->set(0.0, 90.0);
    dial->setFocus(Qt::TabFocusReason);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(dial, Qt::Key_Right);
    EXPECT_NEAR(studio().easel().hand().tilt.tilt_deg, 6.0, 1e-9);
    EXPECT_NEAR(studio().easel().hand().tilt.direction_deg, 0.0, 1e-9);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(dial, Qt::Key_Down);
    EXPECT_NEAR(dial->azimuth_deg(), 45.0, 1e-9);
    QTest::keyClick(dial, Qt::Key_Home);
    EXPECT_EQ(studio().easel().hand().tilt.tilt_deg, 0.0);
}

TEST_F(Keyboard, TypesTheTiltAndTheLight) {
    QApplication::setActiveWindow(&window());
    const auto type = [this](const char* name, const char* digits) {
        auto* box = window().findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, QString::fromLatin1(digits));
        QTest::keyClick(box, Qt::Key_Return);
    };
    auto* dial = window().findChild<panels::TiltDial*>();
    dial->set(12.4, 30.0);
    type("tilt_direction", "200");
    EXPECT_NEAR(studio().easel().hand().tilt.tilt_deg, 12.4, 1e-9) << "what is not typed stays exact";
    EXPECT_NEAR(studio().easel().hand().tilt.direction_deg, 200.0, 1e-9);
    type("tilt", "45");
    EXPECT_NEAR(studio().easel().hand().tilt.tilt_deg, 45.0, 1e-9);
    EXPECT_NEAR(dial->angle_deg(), 45.0, 1e-9) << "the dial follows";
    EXPECT_NEAR(dial->azimuth_deg(), 200.0, 1e-9);
    type("light_height", "20");
    type("light_direction", "300");
    EXPECT_NEAR(canvas().lighting().elevation_deg, 20.0, 1e-9);
    EXPECT_NEAR(canvas().lighting().azimuth_deg, 300.0, 1e-9);
}

TEST_F(Keyboard, TheTiltsKnobIsWhereItIsDragged) {
    auto* dial = window().findChild<panels::TiltDial*>();
    const int side = std::min(dial->width(), dial->height());
    const QPoint to = dial->rect().center() + QPoint(-side / 3, side / 8);
    const QPointF way = to - QRectF(dial->rect()).center();
    QTest::mousePress(dial, Qt::LeftButton, {}, dial->rect().center());
    QTest::mouseMove(dial, to);
    QTest::mouseRelease(dial, Qt::LeftButton, {}, to);
    const QImage shown = dial->grab().toImage();
    EXPECT_GT(shown.pixelColor(to).lightness(), 200);
    // Nothing as light on the other side, which could be taken for the knob.
    const QPoint opposite = 2 * dial->rect().center() - to;
    for (int y = -8; y <= 8; ++y)
        for (int x = -8; x <= 8; ++x)
            EXPECT_LT(shown.pixelColor(opposite + QPoint(x, y)).lightness(), 150);
    const double down_deg = studio().easel().hand().tilt.direction_deg;
    EXPECT_NEAR(down_deg, core::degrees(std::atan2(way.y(), way.x())), 3.0);
}

// ---- dialogs

TEST_F(Keyboard, AToolNeedsAName) {
    bool asked = false;
    QTimer::singleShot(0, [&asked] {
        auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        asked = true;
        const auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        auto* name = dialog->findChild<QLineEdit*>();
        EXPECT_TRUE(ok->isEnabled());
        EXPECT_EQ(name->selectedText(), name->text()) << "typing replaces it";
        name->setText(QStringLiteral("  "));
        EXPECT_FALSE(ok->isEnabled());
        dialog->reject();
    });
    action(Command::SaveBrush)->trigger();
    EXPECT_TRUE(asked);
}

TEST_F(Keyboard, SoDoTagsSetsOfTubesAndWorkspaces) {
    parts().tubes.save_set(QStringLiteral("My tubes"));
    auto* tools = window().findChild<panels::BrushPanel*>();
    auto& sets = window().findChild<panels::PaintPanel*>()->sets();
    const std::vector<std::function<void()>> asks = {
        [&] { Q_EMIT tools->new_tag_wanted(QStringLiteral("Fan 26")); },
        [&] { Q_EMIT sets.save_wanted(); },
        [&] { Q_EMIT sets.rename_wanted(); },
        [&] { action(Command::SaveWorkspace)->trigger(); },
        [&] {
            parts().workspaces.save(QStringLiteral("Mine"));
            action(Command::RenameWorkspace)->trigger();
        },
        [&] { action(Command::SaveWorkspace)->trigger(); }};
    int asked = 0;
    for (const auto& ask : asks) {
        QTimer::singleShot(0, [&asked] {
            auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(dialog, nullptr);
            SCOPED_TRACE(dialog->windowTitle().toStdString());
            ++asked;
            const auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
            auto* name = dialog->findChild<QLineEdit*>();
            EXPECT_EQ(ok->isEnabled(), !name->text().isEmpty());
            name->setText(QStringLiteral("Sea"));
            EXPECT_TRUE(ok->isEnabled());
            name->setText(QStringLiteral("  "));
            EXPECT_FALSE(ok->isEnabled());
            dialog->reject();
        });
        ask();
    }
    EXPECT_EQ(asked, static_cast<int>(asks.size()));
    EXPECT_EQ(parts().workspaces.workspaces().own.size(), 1U) << "none was kept besides";
}

TEST_F(Keyboard, ReachesAllOfTheSettings) {
    using Page = dialogs::SettingsDialog::Page;
    for (const Page page :
         {Page::Appearance, Page::Colour, Page::Keeping, Page::Performance, Page::Machine}) {
        dialogs::SettingsDialog dialog({}, 512, {}, {{"OpenGL", "none"}}, &window());
        dialog.show_page(page);
        expect_all_reached(dialog);
    }
}

TEST_F(Keyboard, ReachesAllOfTheKeys) {
    dialogs::KeysDialog dialog(studio().commands().keys(), &window());
    expect_all_reached(dialog);
}

TEST_F(Keyboard, ReachesAllOfANewCanvasAndOfItsSize) {
    dialogs::NewCanvasDialog fresh(canvas_settings(), 4.0, &window());
    expect_all_reached(fresh);
    dialogs::CanvasSizeDialog size(canvas_settings(), QImage(60, 40, QImage::Format_RGB888), &window());
    expect_all_reached(size);
}

TEST_F(Keyboard, ReachesAllOfTransformAndRange) {
    dialogs::TransformDialog transform({.size_mm = {20.0, 10.0}}, {60.0, 40.0}, &window());
    expect_all_reached(transform);
    dialogs::SelectRangeDialog range(QStringLiteral("Height"), QStringLiteral("Of paint"), {0.0, 1.0},
                                     &window());
    expect_all_reached(range);
    dialogs::MarginDialog margin({.title = QStringLiteral("Grow"),
                                  .explanation = QStringLiteral("On all sides"),
                                  .name = QStringLiteral("Width"),
                                  .button = QStringLiteral("Grow"),
                                  .most_mm = 10.0},
                                 &window());
    expect_all_reached(margin);
}

TEST_F(Keyboard, ReachesAllOfThePens) {
    panels::PenDialog dialog({}, &window());
    expect_all_reached(dialog);
    dialog.show_devices({{"A pen", tools::PenEnd::Tip}});
    expect_all_reached(dialog);
}

TEST_F(Keyboard, ReachesAllOfWhatAFailureLeft) {
    dialogs::CrashDialog crash(QStringLiteral("Ended by: SIGSEGV"), QStringLiteral("/tmp/report"),
                               &window());
    expect_all_reached(crash);
    dialogs::RecoveryDialog recovery({{.folder = "/tmp/nowhere", .painting = "/tmp/a.pastoso"}},
                                     &window());
    expect_all_reached(recovery);
}

TEST_F(Keyboard, ReachesAllOfEveryTexture) {
    using Form = dialogs::ChosenTexture::Form;
    for (const Form form : {Form::Sand, Form::Knifed, Form::Pressed}) {
        dialogs::TextureDialog dialog({.form = form, .picture = QStringLiteral("/tmp/a.png")}, {},
                                      &window());
        expect_all_reached(dialog);
    }
}

TEST_F(Keyboard, ReachesAllOfEveryAdjustment) {
    using Way = dialogs::ChosenAdjustment::Way;
    for (const Way way : {Way::Glaze, Way::Exchange}) {
        dialogs::AdjustDialog dialog(
            {.way = way}, true, [](const auto&) { return tools::AdjustedColours{}; }, &window());
        expect_all_reached(dialog);
    }
}

TEST_F(Keyboard, ReachesAllOfEveryExport) {
    for (int form = 0; form < 5; ++form) {
        action(Command::Export)->trigger();
        auto* dialog = window().findChild<dialogs::ExportDialog*>();
        ASSERT_NE(dialog, nullptr);
        auto* forms = dialog->findChild<QComboBox*>(QStringLiteral("form"));
        forms->setCurrentIndex(form);
        Q_EMIT forms->activated(form);
        expect_all_reached(*dialog);
        dialog->reject();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

}  // namespace
}  // namespace pastoso::tests
