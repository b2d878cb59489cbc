// What a screen reader and the pointer are told of everything in the window.
#include "app/window_fixture.hpp"
#include "appearance/said_value.hpp"
#include "appearance/terms.hpp"
#include "dialogs/adjust_dialog.hpp"
#include "dialogs/canvas_size_dialog.hpp"
#include "dialogs/crash_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/keys_dialog.hpp"
#include "dialogs/length_dialog.hpp"
#include "dialogs/new_canvas_dialog.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "dialogs/rotate_dialog.hpp"
#include "dialogs/scale_dialog.hpp"
#include "dialogs/select_range_dialog.hpp"
#include "dialogs/settings_dialog.hpp"
#include "dialogs/texture_dialog.hpp"
#include "dialogs/transform_dialog.hpp"
#include "glass/liquid_picture_dialog.hpp"
#include "main/window_parts.hpp"
#include "panels/canvas/light_dial.hpp"
#include "panels/canvas/tilt_dial.hpp"
#include "panels/pen/curve_editor.hpp"
#include "panels/pen/pen_dialog.hpp"

#include <memory>
#include <utility>
#include <vector>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QTabBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class SaidWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::Pause)->trigger();
        for (QDockWidget* dock : window().findChildren<QDockWidget*>())
            dock->show();
        QApplication::processEvents();
    }

    static std::string said(QWidget& widget, QAccessible::Text which) {
        QAccessibleInterface* said = QAccessible::queryAccessibleInterface(&widget);
        return said == nullptr ? std::string() : said->text(which).trimmed().toStdString();
    }
    static std::string words_for(const QWidget& widget) {
        std::string words = std::string(widget.metaObject()->className()) + " " +
                            widget.objectName().toStdString() + " in";
        for (const QWidget* around = widget.parentWidget(); around != nullptr;
             around = around->parentWidget())
            if (!around->objectName().isEmpty()) words += " " + around->objectName().toStdString();
        return words;
    }

    /// Of all of a window, those that the Tab key reaches; parts of Qt's own are those around them.
    std::vector<QWidget*> focusable() { return focusable_in(window()); }
    static std::vector<QWidget*> focusable_in(const QWidget& whole) {
        std::vector<QWidget*> found;
        for (QWidget* widget : whole.findChildren<QWidget*>()) {
            const bool is_part = widget->objectName().startsWith(QStringLiteral("qt_")) ||
                                 widget->inherits("QComboBoxListView") ||
                                 qobject_cast<QTabBar*>(widget->parentWidget()) != nullptr ||
                                 qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) != nullptr ||
                                 qobject_cast<QComboBox*>(widget->parentWidget()) != nullptr;
            if ((widget->focusPolicy() & Qt::TabFocus) && !is_part) found.push_back(widget);
        }
        return found;
    }

    /// Qt draws it, and says how it stands.
    static bool is_known_to_qt(const QWidget& widget) {
        for (const char* known :
             {"QAbstractButton", "QAbstractSlider", "QAbstractSpinBox", "QComboBox", "QAbstractItemView",
              "QLineEdit", "QTabBar", "QTextEdit", "QPlainTextEdit"})
            if (widget.inherits(known)) return true;
        return false;
    }
};

TEST_F(SaidWindow, WhateverTakesKeysHasAName) {
    int count = 0;
    for (QWidget* widget : focusable()) {
        if (qobject_cast<QTabBar*>(widget) != nullptr) continue;
        ++count;
        EXPECT_NE(said(*widget, QAccessible::Name), "") << words_for(*widget);
    }
    EXPECT_GT(count, 60);
}

/// One of each that can be opened without a file.
std::vector<std::unique_ptr<QDialog>> all_dialogs(const document::CanvasSettings& canvas,
                                                  const commands::KeyBindings& keys) {
    using Way = dialogs::ChosenAdjustment::Way;
    using Form = dialogs::ChosenTexture::Form;
    const QImage picture(60, 40, QImage::Format_RGB888);
    const dialogs::AskedLength asked{.title = QStringLiteral("Grow"),
                                     .explanation = QStringLiteral("On all sides"),
                                     .name = QStringLiteral("Width"),
                                     .button = QStringLiteral("Grow"),
                                     .most_mm = 10.0};
    std::vector<std::unique_ptr<QDialog>> all;
    const auto add = [&all](auto* dialog) { all.emplace_back(dialog); };
    add(new dialogs::SettingsDialog({}, 512, {}, {{"OpenGL", "none"}}));
    add(new dialogs::KeysDialog(keys));
    add(new dialogs::NewCanvasDialog(canvas, 4.0));
    add(new dialogs::CanvasSizeDialog(canvas, picture));
    add(new dialogs::ScaleDialog(canvas));
    add(new dialogs::RotateDialog(canvas, picture, {}));
    add(new dialogs::TransformDialog({.size_mm = {20.0, 10.0}}, {60.0, 40.0}));
    add(new dialogs::SelectRangeDialog(QStringLiteral("Height"), QStringLiteral("Of paint"),
                                       {0.0, 1.0}));
    add(new dialogs::MarginDialog(asked));
    for (const Form form : {Form::Sand, Form::Knifed, Form::Pressed})
        add(new dialogs::TextureDialog({.form = form, .picture = QStringLiteral("/tmp/a.png")}, {}));
    for (const Way way : {Way::Glaze, Way::Exchange})
        add(new dialogs::AdjustDialog({.way = way}, true,
                                      [](const auto&) { return tools::AdjustedColours{}; }));
    add(new dialogs::CrashDialog(QStringLiteral("Ended by: SIGSEGV"), QStringLiteral("/tmp/report")));
    std::vector<journal::Unfinished> unfinished{
        {.folder = "/tmp/nowhere", .painting = "/tmp/a.pastoso"}};
    add(new dialogs::RecoveryDialog(unfinished));
    add(new panels::PenDialog({}, nullptr));
    add(new glass::LiquidPictureDialog(
        {.name = QStringLiteral("picture_dialog"),
         .title = QStringLiteral("Render"),
         .hint = QStringLiteral("A picture"),
         .file = QStringLiteral("tea.png")},
        [] { return session::LiquidPictureOrder{}; }, nullptr));
    return all;
}

/// Also in a dialog that was never shown.
bool is_put_away(const QWidget& widget) {
    return widget.isHidden() && widget.testAttribute(Qt::WA_WState_ExplicitShowHide);
}

TEST_F(SaidWindow, WhateverTakesKeysInADialogHasAName) {
    const auto expect_names = [](const QDialog& dialog) {
        SCOPED_TRACE(dialog.windowTitle().toStdString());
        int count = 0;
        for (QWidget* widget : focusable_in(dialog)) {
            if (!is_known_to_qt(*widget) || widget->inherits("QTabBar") || is_put_away(*widget)) continue;
            ++count;
            EXPECT_NE(said(*widget, QAccessible::Name), "") << words_for(*widget);
        }
        EXPECT_GT(count, 0);
    };
    for (const auto& dialog : all_dialogs(canvas_settings(), studio().commands().keys()))
        expect_names(*dialog);
    action(Command::Export)->trigger();
    auto* exporting = window().findChild<dialogs::ExportDialog*>();
    ASSERT_NE(exporting, nullptr);
    expect_names(*exporting);
    exporting->reject();
    bool checked = false;
    QTimer::singleShot(0, &window(), [&] {
        auto* about = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(about, nullptr);
        expect_names(*about);
        checked = true;
        about->reject();
    });
    action(Command::About)->trigger();
    EXPECT_TRUE(checked);
}

TEST_F(SaidWindow, WhatDrawsItselfSaysWhatItIsAndHowItStands) {
    int count = 0;
    for (QWidget* widget : focusable()) {
        if (is_known_to_qt(*widget) || !widget->metaObject()->superClass()) continue;
        ++count;
        EXPECT_NE(said(*widget, QAccessible::Value), "") << words_for(*widget);
        EXPECT_NE(QAccessible::queryAccessibleInterface(widget)->role(), QAccessible::Client)
            << words_for(*widget);
    }
    EXPECT_GE(count, 7);
}

TEST_F(SaidWindow, TheCanvasSaysItsSizeAndWhereTheBrushIs) {
    const document::CanvasSettings settings = canvas_settings();
    EXPECT_THAT(said(canvas(), QAccessible::Name),
                HasSubstr("Canvas " + std::to_string(static_cast<int>(settings.width_mm))));
    EXPECT_THAT(said(canvas(), QAccessible::Name), HasSubstr("pixels per millimetre"));
    EXPECT_EQ(QAccessible::queryAccessibleInterface(&canvas())->role(), QAccessible::Canvas);
    move({12.0, 20.0}, Qt::NoButton);
    EXPECT_EQ(said(canvas(), QAccessible::Value), "Brush at 12, 20 mm");
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&canvas(), &leave);
    EXPECT_THAT(said(canvas(), QAccessible::Value), HasSubstr("not over"));
    document::CanvasSettings other = settings;
    other.width_mm = 44.0;
    parts().files.new_canvas(other);
    loaded();
    EXPECT_THAT(said(canvas(), QAccessible::Name), HasSubstr("Canvas 44"));
    EXPECT_EQ(said(studio().well(), QAccessible::Name), "Mixing well");
}

TEST_F(SaidWindow, DialsAndCurvesSayWhatKeysDoToThem) {
    auto& tilt = *window().findChild<panels::TiltDial*>();
    tilt.set(0.0, 90.0);
    EXPECT_EQ(said(tilt, QAccessible::Value), "flat");
    QTest::keyClick(&tilt, Qt::Key_Down);
    EXPECT_EQ(said(tilt, QAccessible::Value), "2° steep, down is at 90°");
    auto& light = *window().findChild<panels::LightDial*>();
    light.set_light(36.0, 135.0);
    EXPECT_EQ(said(light, QAccessible::Value), "36° high, from 135°");
    auto& curve = *window().findChild<panels::CurveEditor*>();
    curve.show_curve({.points = {{0.0, 0.0}, {1.0, 1.0}}});
    QTest::keyClick(&curve, Qt::Key_PageDown);
    EXPECT_THAT(said(curve, QAccessible::Value), HasSubstr("Point 1 of 2: 0 % across"));
    QTest::keyClick(&curve, Qt::Key_PageDown);
    EXPECT_THAT(said(curve, QAccessible::Value), HasSubstr("Point 2 of 2: 100 % across"));
}

TEST_F(SaidWindow, EveryControlSaysWhatItDoes) {
    int count = 0;
    for (QWidget* widget : focusable()) {
        const bool is_list =
            qobject_cast<QAbstractItemView*>(widget) != nullptr || widget->inherits("QPlainTextEdit");
        if (is_list || qobject_cast<QTabBar*>(widget) != nullptr ||
            qobject_cast<QLineEdit*>(widget) != nullptr)
            continue;
        const bool is_canvas = widget == &canvas() || widget == &studio().well();
        const bool is_in_list = widget->parentWidget()->inherits("QAbstractItemView");
        if (is_canvas || is_in_list) continue;
        ++count;
        EXPECT_FALSE(widget->toolTip().isEmpty() && widget->parentWidget()->toolTip().isEmpty())
            << words_for(*widget);
    }
    EXPECT_GT(count, 60);
}

/// That the pointer is told over a label of those words, which may stand as a heading, too.
QString hint_over(const QWidget& window, const QString& words) {
    for (const QWidget* one : window.findChildren<QLabel*>()) {
        if (static_cast<const QLabel*>(one)->text() != words) continue;
        while (one != nullptr && one->toolTip().isEmpty())
            one = one->parentWidget();
        if (one != nullptr) return one->toolTip();
    }
    return {};
}

TEST_F(SaidWindow, WordsOfTheTradeAreExplained) {
    using appearance::Term;
    for (const auto& [words, term] : {std::pair{"Tilt", Term::Tilt},
                                      {"Drying", Term::Drying},
                                      {"Steady", Term::Steadying},
                                      {"Harmony", Term::Harmony},
                                      {"Gamut mask", Term::GamutMask},
                                      {"Varnish", Term::Varnish},
                                      {"Seen in", Term::Seen},
                                      {"Medium ", Term::Medium}})
        EXPECT_EQ(hint_over(window(), QString::fromLatin1(words)), appearance::explanation(term))
            << words;
    const auto* recipe = window().findChild<QLabel*>(QStringLiteral("recipe"));
    ASSERT_NE(recipe, nullptr);
    EXPECT_THAT(recipe->text().toStdString(), HasSubstr("ΔE"));
    EXPECT_EQ(recipe->toolTip(), appearance::explanation(Term::ColourDifference));
    const auto* lights = window().findChild<QComboBox*>(QStringLiteral("illuminant"));
    ASSERT_NE(lights, nullptr);
    for (int light = 0; light < lights->count(); ++light)
        EXPECT_EQ(lights->itemData(light, Qt::ToolTipRole).toString(),
                  lights->itemText(light).contains(QLatin1Char('('))
                      ? appearance::explanation(Term::StandardLights)
                      : QString());
}

TEST_F(SaidWindow, ButtonsOfCommandsSayTheirKey) {
    int count = 0;
    for (const auto* button : window().findChildren<QToolButton*>()) {
        const QAction* action = button->defaultAction();
        if (action == nullptr || action->shortcuts().isEmpty()) continue;
        ++count;
        const QString key = action->shortcuts().front().toString(QKeySequence::NativeText);
        EXPECT_TRUE(button->toolTip().contains(key))
            << words_for(*button) << button->text().toStdString();
        EXPECT_TRUE(button->toolTip().contains(action->statusTip())) << button->text().toStdString();
    }
    EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace pastoso::tests
