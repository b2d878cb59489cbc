// How long a new canvas takes until it can be painted on, seen, and seen in full, from elsewhere, too,
// how long the window stood still meanwhile, and the memory that it came to; and the same of making it
// 16 mm larger.
//
//     LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb xvfb-run -a build/bin/canvas_benchmark [SIDE_MM
//     [PX_PER_MM [SUPPORT [processor | opengl [SECONDS]]]]]

#include "bench/bench_window.hpp"
#include "main/window_parts.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>

#include <QElapsedTimer>
#include <QTimer>

namespace {

using namespace pastoso;

/// What came after so many seconds.
struct Times {
    std::optional<double> begun_s, seen_s, whole_s;
    std::optional<double> painted_s;  ///< from the pen, which comes once the canvas is seen
    double longest_wait_s = 0.0;
};

void tell(const char* what, const std::optional<double>& after_s) {
    if (after_s)
        std::printf("%-40s %7.3f s\n", what, *after_s);
    else
        std::printf("%-40s not yet\n", what);
}

/// Since it began: lets the window do what there is to do, and notes how long that took at most.
class Watch {
  public:
    Watch() {
        wakes_.start(kWake_ms);
        clock_.start();
    }
    double now_s() const { return 1e-9 * static_cast<double>(clock_.nsecsElapsed()); }
    void let_the_window_work() {
        // Asleep in between, as a window is: what is made beside it has both processors.
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        longest_wait_s_ = std::max(longest_wait_s_, now_s() - looked_s_);
        looked_s_ = now_s();
    }
    double longest_wait_s() const { return longest_wait_s_; }

  private:
    static constexpr int kWake_ms = 2;

    QTimer wakes_;
    QElapsedTimer clock_;
    double looked_s_ = 0.0, longest_wait_s_ = 0.0;
};

void paint_a_stroke(tools::Easel& easel, const document::CanvasSettings& canvas) {
    tools::Pointer pointer;
    pointer.pressure = 0.8;
    pointer.y_mm = 0.5 * canvas.height_mm;
    pointer.time_ms = 1000;
    for (double x_mm = 0.45 * canvas.width_mm; x_mm <= 0.55 * canvas.width_mm; x_mm += 2.0) {
        const bool first = pointer.time_ms == 1000;
        pointer.x_mm = x_mm;
        pointer.time_ms += 5;
        if (first)
            easel.press(pointer);
        else
            easel.move(pointer);
    }
    easel.release();
}

Times times_of(bench::Window& shown, const document::CanvasSettings& canvas, double limit_s) {
    main::Studio& studio = shown.studio();
    Times times;
    Watch watch;
    const auto now_s = [&] { return watch.now_s(); };
    const auto begun = QObject::connect(&studio, &main::Studio::session_begun, &studio,
                                        [&] { times.begun_s = now_s(); });
    (*shown).parts().files.new_canvas(canvas);
    double pen_s = 0.0;
    std::shared_ptr<const document::Snapshot> painted;
    while (now_s() < limit_s && !(times.whole_s && times.painted_s)) {
        watch.let_the_window_work();
        const auto* seen = studio.canvas().shown();
        if (!times.begun_s || seen == nullptr || !(seen->bare->settings == canvas)) continue;
        if (!times.seen_s) {
            times.seen_s = pen_s = now_s();
            paint_a_stroke(studio.easel(), canvas);
        }
        const session::Status status = studio.session().status();
        if (painted == nullptr && status.strokes > 0 && !status.stroke_in_progress)
            painted = studio.session().snapshot();
        const bool has_stroke =
            painted != nullptr && (seen == painted.get() || seen->tick > painted->tick);
        if (has_stroke && !times.painted_s) times.painted_s = now_s() - pen_s;
        if (!times.whole_s && studio.canvas().finished()) times.whole_s = now_s();
    }
    QObject::disconnect(begun);
    times.longest_wait_s = watch.longest_wait_s();
    return times;
}

void pan(view::CanvasView& canvas) {
    screen::ViewTransform view = canvas.view_transform();
    view.origin_px += glm::dvec2{57.0, 23.0};
    canvas.look_from(view);
}

/// Until the picture is whole again after what the painter does; none within the limit.
template <class Does>
std::optional<double> whole_after_s(bench::Window& shown, double limit_s, const Does& does) {
    view::CanvasView& canvas = shown.studio().canvas();
    Watch watch;
    does(canvas);
    while (watch.now_s() < limit_s) {
        watch.let_the_window_work();
        if (canvas.finished()) return watch.now_s();
    }
    return std::nullopt;
}

void tell_views(bench::Window& shown, double limit_s) {
    tell("whole from nearer",
         whole_after_s(shown, limit_s, [](view::CanvasView& canvas) { canvas.zoom_about_centre(1.3); }));
    tell("whole from farther",
         whole_after_s(shown, limit_s, [](view::CanvasView& canvas) { canvas.zoom_about_centre(0.7); }));
    tell("whole, panned", whole_after_s(shown, limit_s, pan));
    tell("whole, at a pixel a cell",
         whole_after_s(shown, limit_s, [](view::CanvasView& canvas) { canvas.show_actual_pixels(); }));
    tell("whole, panned there", whole_after_s(shown, limit_s, pan));
}

Times times_of_larger(bench::Window& shown, const document::CanvasSettings& canvas, double limit_s) {
    constexpr double kMargin_mm = 8.0;
    main::Studio& studio = shown.studio();
    const auto before = studio.session().snapshot()->bare;
    Times times;
    Watch watch;
    (*shown).parts().sizing.resize({-kMargin_mm, -kMargin_mm, canvas.width_mm + 2.0 * kMargin_mm,
                                    canvas.height_mm + 2.0 * kMargin_mm});
    while (watch.now_s() < limit_s && !times.whole_s) {
        watch.let_the_window_work();
        if (studio.session().snapshot()->bare == before) continue;
        if (!times.begun_s) times.begun_s = watch.now_s();
        const auto* seen = studio.canvas().shown();
        if (seen == nullptr || seen->bare == before) continue;
        if (!times.seen_s) times.seen_s = watch.now_s();
        if (studio.canvas().finished()) times.whole_s = watch.now_s();
    }
    times.longest_wait_s = watch.longest_wait_s();
    return times;
}

void tell_all(const Times& times) {
    tell("there to paint on", times.begun_s);
    tell("seen", times.seen_s);
    tell("seen in full", times.whole_s);
    tell("the window stood still for", times.longest_wait_s);
}

}  // namespace

int main(int argc, char** argv) {
    bench::prepare();
    QApplication application(argc, argv);
    document::CanvasSettings canvas;
    canvas.width_mm = canvas.height_mm = argc > 1 ? std::atof(argv[1]) : 1024.0;
    canvas.px_per_mm = argc > 2 ? std::atof(argv[2]) : 8.0;
    if (argc > 3) canvas.support = argv[3];
    bench::Window shown({});
    if (!shown.shown()) return EXIT_FAILURE;
    if (argc > 4)
        shown.studio().canvas().set_drawn_by(
            std::string(argv[4]) == "opengl" ? screen::DrawnBy::OpenGl : screen::DrawnBy::Processor);
    QTest::qWait(1500);
    const double limit_s = argc > 5 ? std::atof(argv[5]) : 60.0;
    const Times times = times_of(shown, canvas, limit_s);
    std::printf("%g x %g mm of %s at %g px/mm\n", canvas.width_mm, canvas.height_mm,
                canvas.support.c_str(), canvas.px_per_mm);
    tell_all(times);
    tell("a stroke seen, after the pen", times.painted_s);
    if (times.whole_s) tell_views(shown, limit_s);
    std::printf("made larger by 16 mm\n");
    tell_all(times_of_larger(shown, canvas, limit_s));
    std::printf("%-40s %7.0f MiB\n", "memory at most", core::peak_rss_mib());
    return EXIT_SUCCESS;
}
