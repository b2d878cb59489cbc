// The real window on a small canvas, driven through the windowing system's own events.
#pragma once

#include "core/temporary_folder.hpp"
#include "main/main_window.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QImage>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

namespace pastoso::tests {

/// Fails where there is no display.
class WindowTest : public ::testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    virtual document::CanvasSettings canvas_settings() const;

    /// By OpenGL where the environment has PASTOSO_TEST_OPENGL, else as on this machine.
    virtual screen::DrawnBy drawn_by() const;

    /// A move or a press of the left button, the place in millimetres on the canvas.
    void mouse_stroke(const std::vector<glm::dvec2>& path_mm);
    void mouse_stroke_on(view::CanvasView& view, const std::vector<glm::dvec2>& path_mm);
    void press(const glm::dvec2& place_mm, Qt::MouseButton button = Qt::LeftButton);
    void move(const glm::dvec2& place_mm, Qt::MouseButtons buttons = Qt::LeftButton);
    void release(const glm::dvec2& place_mm, Qt::MouseButton button = Qt::LeftButton);

    struct Pen {
        double pressure = 0.5;
        int tilt_x_deg = 0;
        int tilt_y_deg = 0;
        bool eraser_end = false;
    };
    void pen_stroke(const std::vector<glm::dvec2>& path_mm, const Pen& pen);

    /// The same by a pen that tells its place every so many milliseconds, while the window is busy with
    /// something else: it hears of all of it afterwards.
    void pen_stroke_at_once(const std::vector<glm::dvec2>& path_mm, const Pen& pen, int sample_ms);

    /// One event of the pen over the canvas; a button that was not down before is pressed.
    void pen_at(const glm::dvec2& place_mm, Qt::MouseButtons buttons, const Pen& pen);
    /// The same over any widget, at a place of its own.
    void pen_over(QWidget& widget, const QPointF& place, Qt::MouseButtons buttons, const Pen& pen);
    void pen_stroke_on(view::CanvasView& view, const std::vector<glm::dvec2>& path_mm, const Pen& pen);
    /// It is taken away from the tablet, whatever it pressed before.
    void pen_leaves(const Pen& pen);

    /// Handles events until the condition holds, however long that takes (patience.hpp).
    void wait_for(const std::function<bool()>& condition);
    /// The same until the window of this widget stands on the screen.
    void wait_until_shown(QWidget& widget);

    /// Until what is being opened or made stands on the easel, or came to nothing.
    void loaded();

    /// Until everything posted is applied and the canvas shows it.
    void settle();

    /// The canvas in a window of its own, as large as it is; and back at home.
    void put_canvas_into(QWidget& other);
    void put_canvas_back(QWidget& home, const QSize& size);

    double volume_mm3();
    /// Of the canvas view, after settle() and in its final quality: paint that moves has to be paused
    /// before. The pointer's outline is not in it.
    QImage picture();

    main::MainWindow& window() { return *window_; }
    main::Studio& studio() { return window_->studio(); }
    main::WindowParts& parts() { return window_->parts(); }
    view::CanvasView& canvas() { return studio().canvas(); }
    session::PaintSession& session() { return studio().session(); }
    QAction* action(commands::Command command) { return studio().commands().action(command); }
    std::string told() const;  ///< by the status line

    /// Closes the window as a painter does and opens another.
    void start_again();
    void open_another();

    /// Where the window keeps what it remembers; a test that wants other data sets XDG_DATA_HOME first.
    std::filesystem::path data_file(const char* name) const;
    std::filesystem::path settings_file() const;

  private:
    bool shows(const document::Snapshot& latest);
    void send_pen(QWidget& widget, const QPointF& place, Qt::MouseButtons buttons, const Pen& pen,
                  unsigned long time_ms);

    TemporaryFolder home_;
    bool own_data_ = false;  ///< XDG_DATA_HOME is this fixture's
    std::unique_ptr<main::MainWindow> window_;
};

/// A straight path in so many steps.
std::vector<glm::dvec2> line_mm(const glm::dvec2& from, const glm::dvec2& to, int steps = 20);

/// The largest and the mean difference of 8-bit channel values between two pictures of one size.
struct PictureDifference {
    int largest = 0;
    double mean = 0.0;
};
PictureDifference difference(const QImage& a, const QImage& b);

}  // namespace pastoso::tests
