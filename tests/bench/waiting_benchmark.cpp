// How long clicks and keys wait while all of a canvas is wet with glaze that runs: the pointer moves 200
// times a second, on a clock of its own whatever the window does, and what the window is asked to do
// besides changes every two seconds. Tells for each of these how long the events waited in the queue,
// and what the paint came to meanwhile.
//
//     LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb xvfb-run -a build/bin/waiting_benchmark [SECONDS
//     [PX_PER_MM]]

#include "bench/bench_window.hpp"
#include "document/actions/actions.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <QAction>
#include <QMouseEvent>
#include <QWindow>
#include <qpa/qwindowsysteminterface.h>

namespace {

using namespace pastoso;
using commands::Command;

constexpr int kEvent_ms = 5, kTask_ms = 2000;

class Stopwatch {
  public:
    std::uint64_t us() const {
        const auto passed = std::chrono::steady_clock::now() - start_;
        return static_cast<std::uint64_t>(
            std::chrono::duration_cast<std::chrono::microseconds>(passed).count());
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Times of the events that reach the window; their time stamps count the microseconds at which they
/// were sent.
class Listener : public QObject {
  public:
    explicit Listener(const Stopwatch& clock) : clock_(clock) {}

    void begin() { waits_ms_.clear(); }
    void tell(const char* task, double paint_per_wall) {
        std::sort(waits_ms_.begin(), waits_ms_.end());
        const auto at = [&](double share) {
            return waits_ms_.empty()
                       ? 0.0
                       : waits_ms_[static_cast<std::size_t>(share * (waits_ms_.size() - 1.0))];
        };
        std::printf("%-28s %5zu events waited %6.1f; %6.1f; %6.1f; %6.1f ms; paint %.3f of its pace\n",
                    task, waits_ms_.size(), at(0.5), at(0.95), at(0.99), at(1.0), paint_per_wall);
        std::fflush(stdout);
    }

  protected:
    bool eventFilter(QObject* receiver, QEvent* event) override {
        if (event->type() == QEvent::MouseMove && receiver->isWindowType()) {
            const std::uint64_t sent_us = static_cast<QMouseEvent*>(event)->timestamp();
            waits_ms_.push_back(1e-3 * static_cast<double>(clock_.us() - sent_us));
        }
        return false;
    }

  private:
    const Stopwatch& clock_;
    std::vector<double> waits_ms_;
};

/// Bands of ink glaze over all of the canvas, which then stands at 60 degrees.
void flood(main::Studio& studio) {
    tools::Easel& easel = studio.easel();
    easel.take_brush("Flat bristle 20", 60.0);
    easel.use_medium("ink glaze");
    easel.tilt(60.0, 270.0);
    const document::CanvasSettings canvas = studio.session().canvas();
    std::uint64_t time_ms = 1000;
    for (double y_mm = 20.0; y_mm < canvas.height_mm + 20.0; y_mm += 40.0) {
        tools::Pointer pointer;
        pointer.y_mm = y_mm;
        pointer.pressure = 0.8;
        easel.reload();
        for (double x_mm = 0.0; x_mm <= canvas.width_mm; x_mm += 2.0) {
            pointer.x_mm = x_mm;
            pointer.time_ms = time_ms += 5;
            if (x_mm == 0.0)
                easel.press(pointer);
            else
                easel.move(pointer);
        }
        easel.release();
    }
    studio.session().wait_until_applied();
}

struct Task {
    const char* name;
    std::vector<Command> commands;
};

/// One after the other, again and again.
const std::vector<Task>& tasks() {
    static const std::vector<Task> all{
        {"nothing else", {}},
        {"zoom", {Command::ZoomIn, Command::ZoomOut}},
        {"turn", {Command::TurnLeft, Command::TurnRight}},
        {"panels", {Command::ColourPanel, Command::GuidesPanel}},
        {"width of the brush", {Command::LargerBrush, Command::SmallerBrush}},
        {"undo and redo", {Command::Undo, Command::Redo}},
        {"command search", {Command::FindCommand}}};
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    bench::prepare();
    QApplication application(argc, argv);
    document::CanvasSettings canvas;
    if (argc > 2) canvas.px_per_mm = std::atof(argv[2]);
    bench::Window shown(canvas);
    if (!shown.shown()) return EXIT_FAILURE;
    main::Studio& studio = shown.studio();
    QTest::qWait(2000);
    flood(studio);
    std::printf("%d tiles are awake at %g px/mm\n", studio.session().status().awake_tiles,
                canvas.px_per_mm);

    const Stopwatch clock;
    Listener listener(clock);
    application.installEventFilter(&listener);
    QWindow* window = (*shown).windowHandle();
    const QPointF middle =
        (*shown).mapFromGlobal(studio.canvas().mapToGlobal(QPointF(studio.canvas().rect().center())));
    std::atomic<bool> ends = false;
    std::jthread sender([&] {
        for (std::uint64_t due_us = clock.us(); !ends; due_us += 1000 * kEvent_ms) {
            const std::uint64_t now_us = clock.us();
            if (now_us < due_us) std::this_thread::sleep_for(std::chrono::microseconds(due_us - now_us));
            const QPointF place = middle + QPointF(static_cast<double>(due_us / 7000 % 40), 3.0);
            QWindowSystemInterface::handleMouseEvent<QWindowSystemInterface::AsynchronousDelivery>(
                window, static_cast<ulong>(clock.us()), place, window->mapToGlobal(place), Qt::NoButton,
                Qt::NoButton, QEvent::MouseMove);
        }
    });
    const int tasks_wanted = (argc > 1 ? std::atoi(argv[1]) : 28) * 1000 / kTask_ms;
    for (int i = 0; i < tasks_wanted; ++i) {
        const Task& task = tasks()[static_cast<std::size_t>(i) % tasks().size()];
        listener.begin();
        const Stopwatch spent;
        for (int step = 0; spent.us() < 1000U * kTask_ms; ++step) {
            if (!task.commands.empty())
                studio.commands()
                    .action(task.commands[static_cast<std::size_t>(step) % task.commands.size()])
                    ->trigger();
            QTest::qWait(250);
        }
        listener.tell(task.name, studio.session().status().paint_per_wall);
    }
    ends = true;
    return EXIT_SUCCESS;
}
