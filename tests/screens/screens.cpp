// Takes pictures of the program's main states: for whoever looks after it, and for the manual.
//
//     pastoso-screens PAINTING.pastoso FOLDER
//     pastoso-screens --keys LANGUAGE
//
// The first takes the pictures; a display and folders of its own are needed (packaging/screens.sh). The
// second prints the manual's table of all commands and their keys.

#include "appearance/theme.hpp"
#include "core/version.hpp"
#include "graphics/opengl_support.hpp"
#include "keys_table.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"
#include "states.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <QAction>
#include <QApplication>
#include <QCursor>
#include <QTest>

namespace {

using namespace pastoso;

bool take_all(const QString& painting, const QString& folder) {
    main::MainWindow window(document::CanvasSettings{}, false);
    window.resize(1280, 800);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) return false;
    window.studio().commands().action(commands::Command::Pause)->setChecked(true);
    window.parts().files.open_painting(painting);
    screens::wait_for_painting(window);
    // Its outline is in no picture.
    QCursor::setPos(window.mapToGlobal(QPoint(window.width(), window.height())) + QPoint(40, 40));
    screens::pass_time();
    screens::Camera camera(window, folder);
    screens::take_views(camera);
    screens::take_popups(camera);
    screens::take_dialogs(camera);
    screens::take_lights(camera);
    screens::take_layer_tools(camera);
    screens::take_replay(camera);
    screens::take_accidents(camera);
    screens::take_light_theme(camera);
    screens::take_tea(camera);
    screens::take_tank(camera);
    screens::take_panels(camera);
    screens::take_fresh_canvas(camera, camera.path_of(QStringLiteral("painting")));
    return camera.complete();
}

/// After all else: what is made from then on speaks another language.
bool take_languages(const QString& painting, const QString& folder) {
    QList<QPixmap> windows;
    for (const char* language : {"ja", "sv", "zh_TW"})
        windows.append(screens::foreign_window(QString::fromLatin1(language), painting));
    return screens::write(screens::sheet(windows, static_cast<int>(windows.size())),
                          folder + QStringLiteral("/languages.png"));
}

int print_keys(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    main::speak(QString::fromLocal8Bit(argv[2]));
    std::fputs(screens::keys_page().c_str(), stdout);
    return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == "--keys") return print_keys(argc, argv);
    if (argc != 3) {
        std::fprintf(stderr,
                     "pastoso-screens: give a painting and a folder, or --keys and a language.\n");
        return 2;
    }
    graphics::ask_for_opengl();
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("pastoso"));
    QApplication::setApplicationDisplayName(QStringLiteral("Pastoso"));
    QApplication::setApplicationVersion(QString::fromLatin1(pastoso::core::version()));
    main::speak(QStringLiteral("en"));
    appearance::apply_theme(application, appearance::Theme::Dark);
    const QString painting = QString::fromLocal8Bit(argv[1]), folder = QString::fromLocal8Bit(argv[2]);
    const bool complete = take_all(painting, folder) && take_languages(painting, folder);
    return complete ? EXIT_SUCCESS : EXIT_FAILURE;
}
