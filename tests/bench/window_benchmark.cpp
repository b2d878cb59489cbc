// How long a painter waits: the real window, of 1280 x 800 if not told otherwise, is painted on with a
// brush of 60 pixels by a pen that reports 200 times a second. Each minute, and at the end, it tells the
// times of FrameTimes, the processor seconds of that minute (which stay the same where only other
// programs make it wait), the memory that the program holds and how much of it is in use (the rest is
// kept for what comes next); at the end also how many of the pen events reached the painting.
//
//     LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb xvfb-run -a build/bin/window_benchmark [SECONDS
//     [WIDTH_PX [EVENTS_PER_S [HISTORY_MIB [PX_PER_MM [WINDOW_WIDTH WINDOW_HEIGHT]]]]]]

#include "bench/bench_window.hpp"
#include "document/history.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <malloc.h>
#include <memory>
#include <numbers>
#include <string>

#include <QApplication>
#include <QElapsedTimer>
#include <QPointingDevice>
#include <QTest>
#include <QTimer>
#include <QWindow>
#include <qpa/qwindowsysteminterface.h>

namespace {

using namespace pastoso;

constexpr int kStroke_ms = 900, kLift_ms = 100;
constexpr int kMinute_ms = 60000;

std::unique_ptr<QPointingDevice> pen() {
    using Capability = QInputDevice::Capability;
    auto stylus = std::make_unique<QPointingDevice>(
        QStringLiteral("pen"), 77, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
        Capability::Position | Capability::Pressure | Capability::Hover, 1, 1);
    QWindowSystemInterface::registerInputDevice(stylus.get());
    return stylus;
}

/// Loops that wander over the canvas, a second each, the pen in the air at the end of each.
class Painter {
  public:
    explicit Painter(main::MainWindow& window) : window_(window), pen_(pen()) {}

    void paint_at(int time_ms) {
        const auto canvas = window_.studio().session().canvas();
        const double second = time_ms / 1000.0, turn = 2.0 * std::numbers::pi * second;
        const glm::dvec2 mm{canvas.width_mm * (0.5 + 0.35 * std::cos(0.37 * turn)),
                            canvas.height_mm * (0.5 + 0.35 * std::sin(0.53 * turn))};
        const bool down = time_ms % (kStroke_ms + kLift_ms) < kStroke_ms;
        QWindow* handle = window_.windowHandle();
        const QPointF global =
            window_.studio().canvas().mapToGlobal(window_.studio().canvas().widget_position(mm));
        QWindowSystemInterface::handleTabletEvent(
            handle, static_cast<ulong>(1000 + time_ms), pen_.get(), handle->mapFromGlobal(global),
            global, down ? Qt::LeftButton : Qt::NoButton, down ? 0.5 + 0.3 * std::sin(turn) : 0.0, 0, 0,
            0.0, 0.0, 0);
        sent_ += down ? 1 : 0;
    }

    int sent() const { return sent_; }

  private:
    main::MainWindow& window_;
    std::unique_ptr<QPointingDevice> pen_;
    int sent_ = 0;
};

int arrived(main::MainWindow& window) {
    const document::Recording recording = window.studio().session().recording();
    return static_cast<int>(
        std::count_if(recording.events.begin(), recording.events.end(), [](const auto& event) {
            return std::holds_alternative<document::PenDown>(event.action) ||
                   std::holds_alternative<document::PenMove>(event.action);
        }));
}

double processor_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::size_t bytes_in_use() {
    const struct mallinfo2 memory = ::mallinfo2();
    return memory.uordblks + memory.hblkhd;
}

void tell(const session::FrameTimes& times, int until_s, double used_s) {
    std::printf("%d s: %zu MiB, %zu MiB of it in use, %.1f processor seconds\n%s", until_s,
                core::resident_memory_bytes() >> 20, bytes_in_use() >> 20, used_s,
                times.table().c_str());
    std::fflush(stdout);
}

void tell_end(main::MainWindow& window, const Painter& painter) {
    QApplication::processEvents();
    window.studio().session().wait_until_applied();
    std::printf("pen events sent %d, arrived %d\n", painter.sent(), arrived(window));
}

/// What the command line asks for.
struct Load {
    int seconds = 30;
    double width_px = 60.0;
    int event_ms = 5;
    std::size_t history_bytes = document::History::kDefaultBudget_bytes;
    double px_per_mm = document::CanvasSettings{}.px_per_mm;
    QSize window = bench::kWindow;
};

Load load_of(int argc, char** argv) {
    Load load;
    if (argc > 1) load.seconds = std::atoi(argv[1]);
    if (argc > 2) load.width_px = std::atof(argv[2]);
    if (argc > 3) load.event_ms = 1000 / std::max(1, std::atoi(argv[3]));
    if (argc > 4) load.history_bytes = static_cast<std::size_t>(std::atoi(argv[4])) << 20;
    if (argc > 5) load.px_per_mm = std::atof(argv[5]);
    if (argc > 7) load.window = QSize(std::atoi(argv[6]), std::atoi(argv[7]));
    return load;
}

document::CanvasSettings canvas_of(const Load& load) {
    document::CanvasSettings canvas;
    canvas.px_per_mm = load.px_per_mm;
    return canvas;
}

}  // namespace

int main(int argc, char** argv) {
    bench::prepare();
    QApplication application(argc, argv);
    const Load load = load_of(argc, argv);
    bench::Window shown(canvas_of(load), load.window);
    if (!shown.shown()) return EXIT_FAILURE;
    main::MainWindow& window = *shown;
    window.studio().easel().set_brush_width(load.width_px /
                                            window.studio().session().canvas().px_per_mm);
    window.studio().session().set_history_budget(load.history_bytes);
    QTest::qWait(5000);

    Painter painter(window);
    auto times = std::make_shared<session::FrameTimes>();
    window.studio().measure(times);
    QTest::qWait(2000);
    double told_s = processor_s();
    QElapsedTimer clock;
    clock.start();
    const int end_ms = 1000 * load.seconds;
    for (int next_ms = 0, told_ms = 0; next_ms < end_ms;) {
        QApplication::processEvents(QEventLoop::AllEvents, 1);
        const int due_ms = std::min(static_cast<int>(clock.elapsed()), end_ms);
        for (; next_ms < due_ms; next_ms += load.event_ms)
            painter.paint_at(next_ms);
        if (next_ms < std::min(told_ms + kMinute_ms, end_ms)) continue;
        told_ms = next_ms;
        tell(*times, told_ms / 1000, processor_s() - told_s);
        told_s = processor_s();
        times = std::make_shared<session::FrameTimes>();
        window.studio().measure(times);
    }
    tell_end(window, painter);
    return EXIT_SUCCESS;
}
