#include "states.hpp"

#include "appearance/theme.hpp"
#include "dialogs/settings_dialog.hpp"
#include "main/window_parts.hpp"
#include "panels/pen/pen_pad.hpp"
#include "panels/popup/popup_palette.hpp"
#include "start/start_page.hpp"

#include <cmath>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTest>

namespace pastoso::screens {
namespace {

using commands::Command;

void scribble(QWidget& sheet) {
    const auto place = [&](double way) {
        return QPoint(static_cast<int>((0.06 + 0.88 * way) * sheet.width()),
                      static_cast<int>((0.5 + 0.3 * std::sin(14.0 * way)) * sheet.height()));
    };
    constexpr int kSteps = 80, kStep_ms = 8;
    QTest::mousePress(&sheet, Qt::LeftButton, {}, place(0.0));
    for (int i = 0; i <= kSteps; ++i)
        QTest::mouseMove(&sheet, place(static_cast<double>(i) / kSteps), kStep_ms);
    QTest::mouseRelease(&sheet, Qt::LeftButton, {}, place(1.0));
}

void show_only(QWidget& dialog, dialogs::SettingsDialog::Page page) {
    dynamic_cast<dialogs::SettingsDialog&>(dialog).show_page(page);
}

/// The painting without what surrounds it in the window.
QPixmap canvas_alone(Camera& camera) {
    view::CanvasView& canvas = camera.window().studio().canvas();
    const QPointF corner = canvas.widget_position({0.0, 0.0});
    const QPointF opposite = canvas.widget_position(canvas.canvas_size_mm());
    return camera.look_at_canvas().copy(QRectF(corner, opposite).toRect());
}

/// Where a painter would have it.
void name_file(QWidget& dialog, const QString& path) {
    if (auto* line = dialog.findChild<QLineEdit*>(QStringLiteral("path"))) line->setText(path);
}

void take_start_page(Camera& camera) {
    camera.window().parts().start.show_page();
    pass_time();
    pass_time();
    camera.take(QStringLiteral("start-page"));
    if (auto* page = camera.window().findChild<start::StartPage*>()) page->hide();
}

}  // namespace

void take_views(Camera& camera) {
    constexpr QSize kPart(470, 320);
    take_start_page(camera);
    camera.take(QStringLiteral("window"));
    camera.save(canvas_alone(camera), QStringLiteral("painting"));
    QList<QPixmap> looks;
    for (const Command look :
         {Command::LookWet, Command::LookHeight, Command::LookNormals, Command::LookFlat}) {
        camera.give(look);
        looks.append(middle_of(camera.look_at_canvas(), kPart));
    }
    camera.save(sheet(looks, 2), QStringLiteral("looks"));
    camera.give(Command::LookLit);
    camera.give(Command::TurnRight);
    camera.give(Command::MirrorView);
    camera.take_canvas(QStringLiteral("turned-and-mirrored"));
    camera.give(Command::MirrorView);
    camera.give(Command::TurnUpright);
    camera.give(Command::CanvasOnly);
    camera.take(QStringLiteral("canvas-only"));
    camera.give(Command::CanvasOnly);
    camera.give(Command::MoveLight);
    camera.take_canvas(QStringLiteral("lamp"));
    camera.give(Command::MoveLight);
}

void take_panels(Camera& camera) {
    for (const char* panel : {"tool", "colour", "physics", "light", "layers", "recorder"})
        camera.take_panel(panel);
    for (int i = 0; i < 4; ++i)
        camera.give(Command::ZoomIn);
    camera.take_panel("navigator");
    camera.give(Command::FitCanvas);
    camera.give(Command::ResetPanels);
    pass_time();
}

void take_popups(Camera& camera) {
    const QPixmap canvas = camera.look_at_canvas();
    camera.give(Command::PopupPalette);
    pass_time();
    if (auto* palette = camera.window().findChild<panels::PopupPalette*>()) {
        constexpr QSize kPart(640, 460);
        camera.save(middle_of(with(canvas, camera.window().studio().canvas(), *palette), kPart),
                    QStringLiteral("popup-palette"));
        palette->hide();
    } else {
        camera.complain(QStringLiteral("popup-palette"));
    }
    camera.give(Command::FindCommand);
    auto* list = camera.window().findChild<QFrame*>(QStringLiteral("command_palette"));
    if (list == nullptr) return camera.complain(QStringLiteral("find-command"));
    list->findChild<QLineEdit*>(QStringLiteral("typed"))->setText(QStringLiteral("lay"));
    pass_time();
    camera.save(list->grab(), QStringLiteral("find-command"));
    list->hide();
}

void take_dialogs(Camera& camera) {
    using Page = dialogs::SettingsDialog::Page;
    camera.take_dialog(Command::NewCanvas, QStringLiteral("dialog-new-canvas"));
    camera.take_dialog(Command::CanvasSize, QStringLiteral("dialog-canvas-size"));
    camera.take_dialog(Command::Export, QStringLiteral("dialog-export"),
                       [](QWidget& dialog) { name_file(dialog, QStringLiteral("~/still-life.png")); });
    camera.take_dialog(Command::MakeTimelapse, QStringLiteral("dialog-timelapse"), [](QWidget& dialog) {
        name_file(dialog, QStringLiteral("~/still-life-frames"));
    });
    camera.take_dialog(Command::PaintAgain, QStringLiteral("dialog-paint-again"));
    camera.take_dialog(Command::SelectHeight, QStringLiteral("dialog-select-height"));
    camera.take_dialog(Command::EditKeys, QStringLiteral("dialog-keys"));
    camera.take_dialog(Command::PenSettings, QStringLiteral("dialog-pen"), [](QWidget& dialog) {
        if (auto* pad = dialog.findChild<panels::PenPad*>()) scribble(*pad);
    });
    for (const auto& [page, name] :
         {std::pair{Page::Appearance, "settings-appearance"}, std::pair{Page::Colour, "settings-colour"},
          std::pair{Page::Keeping, "settings-keeping"},
          std::pair{Page::Performance, "settings-performance"},
          std::pair{Page::Machine, "settings-machine"}})
        camera.take_dialog(Command::EditSettings, QString::fromLatin1(name),
                           [page = page](QWidget& dialog) { show_only(dialog, page); });
}

/// The same piece of the painting without and with varnish.
void take_lights(Camera& camera) {
    constexpr QSize kPart(470, 320);
    auto* finish = camera.window().findChild<QComboBox*>(QStringLiteral("varnish"));
    if (finish == nullptr) return camera.complain(QStringLiteral("varnish"));
    QList<QPixmap> pictures{middle_of(camera.look_at_canvas(), kPart)};
    const auto choose = [finish](int index) {
        finish->setCurrentIndex(index);
        Q_EMIT finish->activated(index);
    };
    auto* age = camera.window().findChild<QDoubleSpinBox*>(QStringLiteral("varnish_yellowing"));
    choose(finish->count() - 1);
    constexpr double kOld = 70.0;
    age->setValue(kOld);
    pictures.append(middle_of(camera.look_at_canvas(), kPart));
    camera.save(sheet(pictures, 2), QStringLiteral("varnish"));
    age->setValue(0.0);
    choose(0);
}

void take_light_theme(Camera& camera) {
    appearance::apply_theme(*qApp, appearance::Theme::Light);
    camera.take(QStringLiteral("window-light"));
    appearance::apply_theme(*qApp, appearance::Theme::Dark);
}

}  // namespace pastoso::screens
