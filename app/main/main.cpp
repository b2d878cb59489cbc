// pastoso: the window.

#include "appearance/theme.hpp"
#include "core/fault.hpp"
#include "core/isa_request.hpp"
#include "core/memory.hpp"
#include "core/printable.hpp"
#include "core/resources.hpp"
#include "core/version.hpp"
#include "crash/crash_guard.hpp"
#include "crash/crash_reports.hpp"
#include "dialogs/crash_dialog.hpp"
#include "graphics/opengl_support.hpp"
#include "main/arguments.hpp"
#include "main/main_window.hpp"
#include "main/program/application.hpp"
#include "main/program/desktop_look.hpp"
#include "main/program/display.hpp"
#include "main/program/language.hpp"
#include "main/program/machine_facts.hpp"
#include "main/program/machine_speed.hpp"
#include "main/program/preference_commands.hpp"
#include "main/window_parts.hpp"
#include "start/canvas_choices.hpp"

#include <cstdio>
#include <cstdlib>

#include <QApplication>
#include <QIcon>
#include <QPixmap>
#include <QTimer>

namespace {

using pastoso::main::Arguments;
using pastoso::main::MainWindow;

int fail(const std::string& sentence) {
    std::fprintf(stderr, "pastoso: %s\n", pastoso::core::printable(sentence).c_str());
    return EXIT_FAILURE;
}

/// Once the time has come and the canvas is drawn in full quality.
void take_screenshot_later(MainWindow& window, const Arguments& arguments) {
    const QString path = QString::fromStdString(arguments.screenshot->string());
    auto* poll = new QTimer(&window);
    QObject::connect(poll, &QTimer::timeout, &window, [&window, path, poll] {
        poll->setInterval(50);
        if (window.parts().loading.busy()) return;
        if (!window.studio().canvas().finished() && window.studio().session().status().awake_tiles == 0)
            return;
        poll->stop();
        const bool saved = window.grab().save(path);
        QApplication::exit(saved ? EXIT_SUCCESS : fail("Cannot write " + path.toStdString() + "."));
    });
    poll->start(static_cast<int>(1000.0 * arguments.after_s));
}

/// What the program is started with is opened beside the window. Where it cannot be, whoever wants a
/// picture of it gets none, and who came to paint gets the start page.
void open_file(MainWindow& window, const Arguments& arguments) {
    using pastoso::main::Loading;
    const auto failed = [&window, &arguments](const QString& sentence) {
        if (arguments.screenshot)
            QApplication::exit(fail(sentence.toStdString()));
        else if (!arguments.profile)
            window.parts().start.welcome();
    };
    const Loading& loading = window.parts().loading;
    auto* opening = new QObject(&window);
    QObject::connect(&loading, &Loading::failed, opening, failed);
    QObject::connect(&loading, &Loading::ended, opening, &QObject::deleteLater);
    window.open_file(*arguments.file);
}

/// First of a run that failed: what it says of that. What was painted in it stands on the start page,
/// or is offered alone where the painter came for a file, or to measure.
void meet_painter(MainWindow& window, bool with_page) {
    if (const auto report = pastoso::crash::take_report(pastoso::crash::reports_folder())) {
        pastoso::dialogs::CrashDialog dialog(QString::fromStdString(report->text),
                                             QString::fromStdString(report->file.string()), &window);
        dialog.exec();
    }
    if (with_page)
        window.parts().start.welcome();
    else
        window.parts().files.offer_recovery();
    if (with_page) window.parts().tour.begin_at_first_start(!window.parts().start.page_is_shown());
}

void use(const pastoso::tools::Preferences& preferences) {
    pastoso::main::apply_preferences(preferences);
    pastoso::main::speak(QString::fromStdString(preferences.language));
}

/// Before there is anything that is laid out for its words.
void scale_text_as_desktop() {
    constexpr int kMostWait_ms = 300;
    if (pastoso::main::qt_scales_text()) return;
    const auto scale = pastoso::main::wanted_text_scale(pastoso::main::desktop_bus(), kMostWait_ms);
    if (scale) pastoso::appearance::scale_text(*scale);
}

void guard_against_crashes() {
    const std::filesystem::path folder = pastoso::crash::reports_folder();
    if (folder.empty()) return;
    pastoso::crash::guard(folder,
                          pastoso::dialogs::words_of(pastoso::main::machine_facts()).toStdString());
}

pastoso::document::CanvasSettings first_canvas(double live_px_per_mm) {
    pastoso::document::CanvasSettings canvas;
    canvas.px_per_mm = pastoso::start::sensible_px_per_mm(
        canvas.width_mm, canvas.height_mm, {live_px_per_mm, pastoso::core::available_memory_bytes()});
    return canvas;
}

int run(const Arguments& arguments, const pastoso::main::KeptPreferences& preferences) {
    const double live_px_per_mm = arguments.screenshot ? pastoso::document::CanvasSettings{}.px_per_mm
                                                       : pastoso::main::live_px_per_mm();
    MainWindow window(first_canvas(live_px_per_mm), !arguments.screenshot, preferences);
    window.studio().set_live_px_per_mm(live_px_per_mm);
    const bool with_page = !arguments.file && !arguments.profile;
    window.show();
    if (arguments.file) open_file(window, arguments);
    if (arguments.screenshot)
        take_screenshot_later(window, arguments);
    else
        QTimer::singleShot(0, &window, [&window, with_page] { meet_painter(window, with_page); });
    if (!arguments.profile) return QApplication::exec();
    const auto times = std::make_shared<pastoso::session::FrameTimes>();
    window.studio().measure(times);
    const int exit_status = QApplication::exec();
    std::fputs(times->table().c_str(), stdout);
    return exit_status;
}

int start(int argc, char** argv) {
    const auto [arguments, exit_status] = pastoso::main::parse_arguments(argc, argv);
    if (exit_status) return *exit_status;
    pastoso::core::check_isa_request();
    pastoso::graphics::ask_for_opengl();
    pastoso::main::expect_display();
    pastoso::main::Application application(argc, argv);
    pastoso::main::display_found();
    pastoso::graphics::ask_for_deep_colour();
    QApplication::setApplicationName(QStringLiteral("pastoso"));
    QApplication::setApplicationDisplayName(QStringLiteral("Pastoso"));
    QApplication::setApplicationVersion(QString::fromLatin1(pastoso::core::version()));
    // The name that the files for desktops have (packaging/desktop).
    QGuiApplication::setDesktopFileName(QStringLiteral("org.pastoso.Pastoso"));
    QApplication::setWindowIcon(
        QIcon(QString::fromStdString(pastoso::core::resource_path("program/pastoso.svg").string())));
    scale_text_as_desktop();
    const pastoso::main::KeptPreferences preferences = pastoso::main::kept_preferences();
    use(preferences.values);
    guard_against_crashes();
    return run(arguments, preferences);
}

}  // namespace

int main(int argc, char** argv) {
    pastoso::core::keep_freed_memory();
    int exit_status = EXIT_FAILURE;
    const auto fault = pastoso::core::fault_of([&] { exit_status = start(argc, argv); });
    return fault.empty() ? exit_status : fail(fault.text());
}
