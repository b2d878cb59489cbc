// Takes pictures of the program's main states: for whoever looks after it, and for the manual.
//
//     pastoso-screens PAINTING.pastoso FOLDER
//
// A display and folders of its own are needed (packaging/screens.sh).

#include "appearance/theme.hpp"
#include "dialogs/settings_dialog.hpp"
#include "main/main_window.hpp"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QTest>
#include <QTimer>

namespace {

using namespace pastoso;
using commands::Command;

constexpr int kPatience_ms = 30000, kOpening_ms = 400;

QWidget* open_dialog() {
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->isVisible() && qobject_cast<QDialog*>(widget) != nullptr) return widget;
    return nullptr;
}

/// The window, and where its pictures go.
class Screens {
  public:
    Screens(main::MainWindow& window, QString folder) : window_(window), folder_(std::move(folder)) {}

    void give(Command command) { window_.commands().action(command)->trigger(); }

    /// Of the whole window, or of a part of it, once the canvas stands there in full.
    void take(const QString& name, QWidget* part = nullptr) {
        settle();
        save((part != nullptr ? part : &window_)->grab(), name);
    }

    /// Of the dialog that the command opens, after `prepare` has had its way with it.
    void take_dialog(Command command, const QString& name,
                     const std::function<void(QWidget&)>& prepare = {}) {
        bool taken = false;
        QTimer::singleShot(kOpening_ms, [&] {
            taken = true;
            QWidget* dialog = open_dialog();
            if (dialog == nullptr) {
                complain(name);
                return;
            }
            if (prepare) prepare(*dialog);
            QApplication::processEvents();
            save(dialog->grab(), name);
            dialog->close();
        });
        give(command);
        // Some dialogs stay open while the program goes on.
        if (!QTest::qWaitFor([&taken] { return taken; }, kPatience_ms)) complain(name);
    }

    /// A panel by the name of its dock.
    void take_panel(Command command, const QString& dock, const QString& name) {
        auto* panel = window_.findChild<QDockWidget*>(dock);
        if (panel == nullptr) {
            complain(name);
            return;
        }
        give(command);
        panel->show();
        panel->raise();
        take(name, panel);
    }

    bool complete() const { return complete_; }

  private:
    void settle() {
        const auto finished = [this] {
            QApplication::processEvents();
            return window_.canvas().finished() &&
                   window_.canvas().shown() == window_.session().snapshot().get();
        };
        window_.session().wait_until_applied();
        if (!QTest::qWaitFor(finished, kPatience_ms))
            std::fprintf(stderr, "The canvas is still drawn.\n");
    }

    void save(const QPixmap& picture, const QString& name) {
        const QString path = folder_ + QLatin1Char('/') + name + QStringLiteral(".png");
        if (!picture.save(path)) complain(path);
    }

    void complain(const QString& name) {
        std::fprintf(stderr, "No picture %s could be taken.\n", qPrintable(name));
        complete_ = false;
    }

    main::MainWindow& window_;
    QString folder_;
    bool complete_ = true;
};

void take_looks(Screens& screens) {
    screens.take(QStringLiteral("window"));
    for (const auto& [look, name] :
         {std::pair{Command::LookWet, "look-wet"}, std::pair{Command::LookHeight, "look-height"},
          std::pair{Command::LookNormals, "look-normals"}, std::pair{Command::LookFlat, "look-flat"}}) {
        screens.give(look);
        screens.take(QString::fromLatin1(name));
    }
    screens.give(Command::LookLit);
    screens.give(Command::TurnRight);
    screens.give(Command::MirrorView);
    screens.take(QStringLiteral("turned-and-mirrored"));
    screens.give(Command::MirrorView);
    screens.give(Command::TurnUpright);
    screens.give(Command::CanvasOnly);
    screens.take(QStringLiteral("canvas-only"));
    screens.give(Command::CanvasOnly);
    screens.give(Command::MoveLight);
    screens.take(QStringLiteral("lamp"));
    screens.give(Command::MoveLight);
}

void take_panels(Screens& screens) {
    screens.take_panel(Command::ToolPanel, QStringLiteral("tool_panel"), QStringLiteral("panel-tool"));
    screens.take_panel(Command::ColourPanel, QStringLiteral("colour_panel"),
                       QStringLiteral("panel-colour"));
    screens.take_panel(Command::PhysicsPanel, QStringLiteral("physics_panel"),
                       QStringLiteral("panel-physics"));
    screens.take_panel(Command::GuidesPanel, QStringLiteral("guides_panel"),
                       QStringLiteral("panel-guides"));
    screens.take_panel(Command::TracingPanel, QStringLiteral("tracing_panel"),
                       QStringLiteral("panel-tracing"));
    screens.take_panel(Command::HistoryPanel, QStringLiteral("history_panel"),
                       QStringLiteral("panel-history"));
    screens.take_panel(Command::LayersPanel, QStringLiteral("layers_panel"),
                       QStringLiteral("panel-layers"));
}

void take_dialogs(Screens& screens) {
    screens.take_dialog(Command::NewCanvas, QStringLiteral("dialog-new-canvas"));
    screens.take_dialog(Command::CanvasSize, QStringLiteral("dialog-canvas-size"));
    screens.take_dialog(Command::Export, QStringLiteral("dialog-export"));
    screens.take_dialog(Command::SelectHeight, QStringLiteral("dialog-select-height"));
    screens.take_dialog(Command::EditKeys, QStringLiteral("dialog-keys"));
    using Page = dialogs::SettingsDialog::Page;
    for (const auto& [page, name] : {std::pair{Page::Appearance, "settings-appearance"},
                                     std::pair{Page::Keeping, "settings-keeping"},
                                     std::pair{Page::Performance, "settings-performance"},
                                     std::pair{Page::Machine, "settings-machine"}}) {
        screens.take_dialog(Command::EditSettings, QString::fromLatin1(name),
                            [page = page](QWidget& dialog) {
                                qobject_cast<dialogs::SettingsDialog*>(&dialog)->show_page(page);
                            });
    }
}

void take_themes(Screens& screens) {
    appearance::apply_theme(*qApp, appearance::Theme::Light);
    screens.take(QStringLiteral("window-light"));
    appearance::apply_theme(*qApp, appearance::Theme::Dark);
}

int take_all(const QString& painting, const QString& folder) {
    main::MainWindow window(document::CanvasSettings{}, false);
    window.resize(1280, 800);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) return EXIT_FAILURE;
    window.commands().action(Command::Pause)->setChecked(true);
    window.open_painting(painting);
    QTest::qWait(1000);
    Screens screens(window, folder);
    take_looks(screens);
    take_panels(screens);
    take_dialogs(screens);
    take_themes(screens);
    return screens.complete() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "pastoso-screens: give a painting and a folder.\n");
        return 2;
    }
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("pastoso"));
    QApplication::setApplicationDisplayName(QStringLiteral("Pastoso"));
    QApplication::setApplicationVersion(QStringLiteral(PASTOSO_VERSION));
    appearance::apply_theme(application, appearance::Theme::Dark);
    return take_all(QString::fromLocal8Bit(argv[1]), QString::fromLocal8Bit(argv[2]));
}
