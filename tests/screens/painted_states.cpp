// The states in which something is painted, moved or played, or has failed.

#include "core/version.hpp"
#include "dialogs/crash_dialog.hpp"
#include "dialogs/recovery_dialog.hpp"
#include "main/files/replay_window.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"
#include "states.hpp"

#include <chrono>
#include <cmath>
#include <numbers>

#include <QAction>
#include <QBuffer>
#include <QDialog>
#include <QDockWidget>

namespace pastoso::screens {
namespace {

using commands::Command;

/// A wavy stroke from left to right over a surface, in shares of its size.
void stroke(tools::Easel& easel, document::Surface surface, const glm::dvec2& size_mm,
            const glm::dvec2& from, const glm::dvec2& to) {
    constexpr int kSteps = 60;
    constexpr std::uint64_t kStep_ms = 12;
    static std::uint64_t time_ms = 1000;
    const auto pointer = [&](int step) {
        const double way = static_cast<double>(step) / kSteps;
        const glm::dvec2 place = size_mm * (from + (to - from) * way);
        tools::Pointer at;
        at.x_mm = place.x;
        at.y_mm = place.y + 0.03 * size_mm.y * std::sin(9.0 * way);
        at.surface = surface;
        at.pressure = 0.6;
        at.time_ms = time_ms += kStep_ms;
        return at;
    };
    easel.press(pointer(0));
    for (int step = 1; step <= kSteps; ++step)
        easel.move(pointer(step));
    easel.release();
}

/// Ultramarine, white and yellow, partly mixed.
void take_mixing_well(Camera& camera) {
    main::MainWindow& window = camera.window();
    camera.give(Command::MixingWell);
    constexpr glm::dvec2 kWell_mm{120.0, 90.0};
    const std::pair<const char*, glm::dvec2> dollops[] = {
        {"PB29", {0.18, 0.25}}, {"PW6", {0.5, 0.2}}, {"PY35", {0.82, 0.25}}, {"PR108", {0.2, 0.75}}};
    for (const auto& [pigment, place] : dollops) {
        window.studio().easel().choose_paint({{{pigment, 1.0}}, 1.0});
        for (int i = 0; i < 3; ++i)
            window.studio().easel().squeeze(kWell_mm.x * place.x, kWell_mm.y * place.y);
    }
    window.studio().easel().clean();
    const auto mix = [&](const glm::dvec2& from, const glm::dvec2& to) {
        stroke(window.studio().easel(), document::Surface::Well, kWell_mm, from, to);
    };
    mix({0.15, 0.25}, {0.75, 0.55});
    mix({0.8, 0.22}, {0.35, 0.62});
    mix({0.5, 0.2}, {0.55, 0.7});
    mix({0.3, 0.5}, {0.8, 0.6});
    pass_time();
    camera.settle();
    auto* panel = window.findChild<QDockWidget*>(QStringLiteral("well_panel"));
    if (panel == nullptr || !wait_for([&] { return window.studio().well().finished(); }))
        return camera.complain(QStringLiteral("mixing-well"));
    camera.save(panel->grab(), QStringLiteral("mixing-well"));
    camera.give(Command::MixingWell);
}

}  // namespace

void take_layer_tools(Camera& camera) {
    main::MainWindow& window = camera.window();
    const glm::dvec2 size_mm = window.studio().canvas().canvas_size_mm();
    document::SelectArea area;
    constexpr int kCorners = 40;
    constexpr double kRound = 2.0 * std::numbers::pi;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = kRound * i / kCorners;
        area.outline.push_back(
            {size_mm.x * (0.42 + 0.16 * std::cos(angle)), size_mm.y * (0.55 + 0.24 * std::sin(angle))});
    }
    window.studio().easel().select(area);
    camera.take_canvas(QStringLiteral("selection"));
    camera.give(Command::TransformLayer);
    pass_time();
    QPixmap canvas = camera.look_at_canvas();
    for (QDialog* dialog : window.findChildren<QDialog*>())
        if (dialog->isVisible()) canvas = with(canvas, window.studio().canvas(), *dialog);
    camera.save(canvas, QStringLiteral("transform"));
    camera.give(Command::TransformLayer);
    window.studio().easel().undo();
    camera.settle();
}

/// Half of it painted.
void take_replay(Camera& camera) {
    camera.give(Command::Play);
    auto* replay = camera.window().findChild<main::ReplayWindow*>();
    if (replay == nullptr) return camera.complain(QStringLiteral("watch-it-grow"));
    replay->replayer().set_playing(false);
    replay->replayer().seek(replay->replayer().status().end_tick / 2);
    const bool found = wait_for([replay] { return !replay->replayer().status().seeking; });
    pass_time();
    if (!found || !wait_for([replay] { return replay->canvas().finished(); }))
        camera.complain(QStringLiteral("watch-it-grow"));
    camera.save(replay->grab(), QStringLiteral("watch-it-grow"));
    replay->close();
    pass_time();
}

/// What the program says after it has failed.
void take_accidents(Camera& camera) {
    dialogs::CrashDialog crash(QStringLiteral("Program: Pastoso %1\n"
                                              "Signal: SIGSEGV (memory that is not the program's)\n"
                                              "Functions under way:\n"
                                              "pastoso::film::step(pastoso::film::FilmState&, double)\n"
                                              "pastoso::document::Painting::play_tick()\n")
                                   .arg(QString::fromLatin1(core::version())),
                               QStringLiteral("~/.local/state/pastoso/crashes/2026-01-31-1200.txt"));
    crash.resize(600, 320);
    camera.save(crash.grab(), QStringLiteral("dialog-crash"));
    QBuffer thumbnail;
    camera.look_at_canvas().scaledToWidth(240, Qt::SmoothTransformation).save(&thumbnail, "PNG");
    journal::Unfinished painting;
    painting.painting = "/home/painter/apples.pastoso";
    painting.canvas = camera.window().studio().session().canvas();
    painting.last_painted = std::chrono::system_clock::now() - std::chrono::minutes(3);
    painting.changes = 27;
    painting.thumbnail = thumbnail.data().toStdString();
    dialogs::RecoveryDialog recovery({painting});
    camera.save(recovery.grab(), QStringLiteral("dialog-recovery"));
}

void take_fresh_canvas(Camera& camera, const QString& traced) {
    main::MainWindow& window = camera.window();
    window.parts().files.new_canvas(document::CanvasSettings{});
    wait_for_painting(window);
    const glm::dvec2 size_mm = window.studio().canvas().canvas_size_mm();
    window.parts().tracing.trace_picture(traced);
    wait_for_painting(window);
    window.studio().easel().choose_paint({{{"PR108", 1.0}}, 1.0});
    stroke(window.studio().easel(), document::Surface::Canvas, size_mm, {0.2, 0.3}, {0.7, 0.35});
    camera.take_canvas(QStringLiteral("tracing"));
    camera.take_panel("tracing");
    camera.give(Command::RemoveTracing);
    take_mixing_well(camera);
    camera.give(Command::MirrorSymmetry);
    camera.give(Command::Ellipse);
    window.studio().easel().choose_paint({{{"PB29", 1.0}}, 1.0});
    stroke(window.studio().easel(), document::Surface::Canvas, size_mm, {0.1, 0.7}, {0.4, 0.85});
    camera.take_canvas(QStringLiteral("guides"));
    camera.take_panel("guides");
    camera.take_panel("history");
    camera.give(Command::RemoveGuides);
}

/// A corner of it.
QPixmap foreign_window(const QString& language, const QString& painting) {
    main::speak(language);
    main::MainWindow window(document::CanvasSettings{}, false);
    window.resize(1280, 800);
    window.show();
    window.studio().commands().action(Command::Pause)->setChecked(true);
    window.parts().files.open_painting(painting);
    wait_for_painting(window);
    Camera camera(window, {});
    pass_time();
    return camera.look().copy(0, 0, 460, 460);
}

}  // namespace pastoso::screens
