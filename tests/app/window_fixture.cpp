#include "app/window_fixture.hpp"

#include "appearance/theme.hpp"
#include "dialogs/adjust_dialog.hpp"
#include "graphics/opengl_support.hpp"
#include "main/program/application.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"
#include "patience.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <private/qhighdpiscaling_p.h>

#include <QApplication>
#include <QStatusBar>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>
#include <qpa/qwindowsysteminterface.h>

namespace pastoso::tests {
namespace {

constexpr int kPatience_ms = std::chrono::milliseconds(kPatience).count();

const QPointingDevice* stylus() {
    using Capability = QInputDevice::Capability;
    static const QPointingDevice* device = [] {
        auto* made =
            new QPointingDevice(QStringLiteral("test stylus"), 77, QInputDevice::DeviceType::Stylus,
                                QPointingDevice::PointerType::Pen,
                                Capability::Position | Capability::Pressure | Capability::XTilt |
                                    Capability::YTilt | Capability::Hover,
                                1, 3);
        QWindowSystemInterface::registerInputDevice(made);
        return made;
    }();
    return device;
}

const QPointingDevice* eraser_end() {
    static const QPointingDevice* device = [] {
        auto* made = new QPointingDevice(
            QStringLiteral("test eraser"), 78, QInputDevice::DeviceType::Stylus,
            QPointingDevice::PointerType::Eraser,
            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
        QWindowSystemInterface::registerInputDevice(made);
        return made;
    }();
    return device;
}

/// Made by the first test and never destroyed: Qt allows one for a process.
void make_application() {
    static int argc = 1;
    static char name[] = "app_window_test";
    static char* argv[] = {name, nullptr};
    if (QApplication::instance() != nullptr) return;
    graphics::ask_for_opengl();
    // The profile of the screen that the tests happen to run on is not theirs.
    qputenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nonexistent");
    auto* application = new main::Application(argc, argv);
    main::speak(QStringLiteral("C"));
    appearance::apply_theme(*application, appearance::Theme::Dark);
    stylus();
    eraser_end();
}

/// Milliseconds for the next event, ten apart like those of a slow tablet.
ulong next_time_ms() {
    static ulong time_ms = 1000;
    return time_ms += 10;
}

/// On the one clock: QTest's own runs ahead by half a second at every click.
void send_mouse(view::CanvasView& canvas, QEvent::Type type, const glm::dvec2& place_mm,
                Qt::MouseButton button, Qt::MouseButtons buttons) {
    const QPointF position = canvas.widget_position(place_mm);
    QMouseEvent event(type, position, canvas.mapToGlobal(position), button, buttons, {});
    event.setTimestamp(next_time_ms());
    QApplication::sendEvent(&canvas, &event);
}

}  // namespace

void WindowTest::SetUp() {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
        GTEST_FAIL() << "no display: run under packaging/test.sh or xvfb-run";
    }
    make_application();
    ASSERT_EQ(graphics::opengl_support().problem, "");
    own_data_ = std::getenv("XDG_DATA_HOME") == nullptr;
    if (own_data_) ::setenv("XDG_DATA_HOME", (home_.path() / "data").c_str(), 1);
    ::setenv("XDG_STATE_HOME", (home_.path() / "state").c_str(), 1);
    ::setenv("XDG_CONFIG_HOME", (home_.path() / "config").c_str(), 1);
    open_another();
}

void WindowTest::TearDown() {
    window_.reset();
    ::unsetenv("XDG_CONFIG_HOME");
    ::unsetenv("XDG_STATE_HOME");
    if (own_data_) ::unsetenv("XDG_DATA_HOME");
}

void WindowTest::open_another() {
    window_.reset();
    window_ = std::make_unique<main::MainWindow>(canvas_settings());
    for (view::CanvasView* view : studio().views())
        view->set_drawn_by(drawn_by());
    window_->resize(1180, 640);
    window_->show();
    wait_until_shown(*window_);
    // Within this program alone: the tests beside it share the display, which has one focus.
    QApplication::setActiveWindow(window_.get());
    settle();
}

void WindowTest::start_again() {
    window_->close();
    open_another();
}

std::filesystem::path WindowTest::data_file(const char* name) const {
    return std::filesystem::path(std::getenv("XDG_DATA_HOME")) / "pastoso" / name;
}

std::filesystem::path WindowTest::settings_file() const {
    return home_.path() / "config" / "pastoso" / "settings.json";
}

screen::DrawnBy WindowTest::drawn_by() const {
    const char* wanted = std::getenv("PASTOSO_TEST_OPENGL");
    return wanted != nullptr ? screen::DrawnBy::OpenGl : screen::DrawnBy::Fastest;
}

document::CanvasSettings WindowTest::canvas_settings() const {
    document::CanvasSettings canvas;
    canvas.width_mm = 60.0;
    canvas.height_mm = 40.0;
    canvas.px_per_mm = 4.0;
    return canvas;
}

void WindowTest::press(const glm::dvec2& place_mm, Qt::MouseButton button) {
    send_mouse(canvas(), QEvent::MouseButtonPress, place_mm, button, button);
}

void WindowTest::move(const glm::dvec2& place_mm, Qt::MouseButtons buttons) {
    send_mouse(canvas(), QEvent::MouseMove, place_mm, Qt::NoButton, buttons);
}

void WindowTest::release(const glm::dvec2& place_mm, Qt::MouseButton button) {
    send_mouse(canvas(), QEvent::MouseButtonRelease, place_mm, button, Qt::NoButton);
}

void WindowTest::mouse_stroke(const std::vector<glm::dvec2>& path_mm) {
    press(path_mm.front());
    for (const glm::dvec2& place_mm : path_mm)
        move(place_mm);
    release(path_mm.back());
}

void WindowTest::mouse_stroke_on(view::CanvasView& view, const std::vector<glm::dvec2>& path_mm) {
    const auto place = [&](const glm::dvec2& place_mm) { return view.widget_position(place_mm); };
    QTest::mousePress(&view, Qt::LeftButton, {}, place(path_mm.front()).toPoint());
    for (const glm::dvec2& place_mm : path_mm) {
        QMouseEvent event(QEvent::MouseMove, place(place_mm), view.mapToGlobal(place(place_mm)),
                          Qt::NoButton, Qt::LeftButton, {});
        event.setTimestamp(next_time_ms());
        QApplication::sendEvent(&view, &event);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, place(path_mm.back()).toPoint());
}

void WindowTest::pen_stroke(const std::vector<glm::dvec2>& path_mm, const Pen& pen) {
    pen_stroke_on(canvas(), path_mm, pen);
}

void WindowTest::pen_stroke_on(view::CanvasView& view, const std::vector<glm::dvec2>& path_mm,
                               const Pen& pen) {
    Pen lifted = pen;
    lifted.pressure = 0.0;
    pen_over(view, view.widget_position(path_mm.front()), Qt::NoButton, lifted);
    for (const glm::dvec2& place_mm : path_mm)
        pen_over(view, view.widget_position(place_mm), Qt::LeftButton, pen);
    pen_over(view, view.widget_position(path_mm.back()), Qt::NoButton, lifted);
}

void WindowTest::pen_at(const glm::dvec2& place_mm, Qt::MouseButtons buttons, const Pen& pen) {
    pen_over(canvas(), canvas().widget_position(place_mm), buttons, pen);
}

void WindowTest::pen_over(QWidget& widget, const QPointF& place, Qt::MouseButtons buttons,
                          const Pen& pen) {
    send_pen(widget, place, buttons, pen, next_time_ms());
    QApplication::processEvents();
}

void WindowTest::pen_leaves(const Pen& pen) {
    QWindowSystemInterface::handleTabletEnterLeaveProximityEvent(
        nullptr, next_time_ms(), pen.eraser_end ? eraser_end() : stylus(), false);
    QApplication::processEvents();
}

void WindowTest::send_pen(QWidget& widget, const QPointF& place, Qt::MouseButtons buttons,
                          const Pen& pen, unsigned long time_ms) {
    QWindow* handle = widget.window()->windowHandle();
    const QPointF global = widget.mapToGlobal(place);
    QWindowSystemInterface::handleTabletEvent(
        handle, time_ms, pen.eraser_end ? eraser_end() : stylus(),
        QHighDpi::toNativeLocalPosition(handle->mapFromGlobal(global), handle),
        QHighDpi::toNativeGlobalPosition(global, handle), buttons, pen.pressure, pen.tilt_x_deg,
        pen.tilt_y_deg, 0.0, 0.0, 0);
}

void WindowTest::pen_stroke_at_once(const std::vector<glm::dvec2>& path_mm, const Pen& pen,
                                    int sample_ms) {
    const unsigned long start_ms = next_time_ms();
    for (std::size_t i = 0; i <= path_mm.size(); ++i) {
        const bool down = i < path_mm.size();
        send_pen(canvas(), canvas().widget_position(path_mm[down ? i : i - 1]),
                 down ? Qt::LeftButton : Qt::NoButton, pen, start_ms + sample_ms * i);
    }
    QApplication::processEvents();
}

void WindowTest::loaded() {
    wait_for([this] { return !parts().loading.busy(); });
}

void WindowTest::wait_for(const std::function<bool()>& condition) {
    ASSERT_TRUE(QTest::qWaitFor(condition, kPatience_ms));
}

void WindowTest::wait_until_shown(QWidget& widget) {
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget, kPatience_ms));
}

/// The latest painting, or what is previewed of it.
bool WindowTest::shows(const document::Snapshot& latest) {
    const document::Snapshot* shown = canvas().shown();
    if (shown == &latest) return true;
    const auto* asked = window_->findChild<dialogs::AdjustDialog*>();
    return asked != nullptr && asked->isVisible() && shown != nullptr && shown->tick == latest.tick &&
           shown->posted_actions >= latest.posted_actions;
}

void WindowTest::settle() {
    QApplication::processEvents();
    session().wait_until_applied();
    const auto latest = session().snapshot();
    wait_for([&] {
        const document::Snapshot* shown = canvas().shown();
        // What is shown may make the window post more: then a later one of the same tick stands there.
        return shows(*latest) || shown == session().snapshot().get() ||
               (shown != nullptr && shown->tick > latest->tick);
    });
}

std::string WindowTest::told() const {
    return window_->statusBar()->currentMessage().toStdString();
}

void WindowTest::put_canvas_into(QWidget& other) {
    const QSize size = canvas().size();
    auto* layout = new QVBoxLayout(&other);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&canvas());
    other.resize(size);
    other.show();
    wait_until_shown(other);
}

void WindowTest::put_canvas_back(QWidget& home, const QSize& size) {
    home.layout()->addWidget(&canvas());
    canvas().show();
    wait_for([&] { return canvas().size() == size; });
}

double WindowTest::volume_mm3() {
    session().wait_until_applied();
    const film::FilmState film = session().snapshot()->film;
    return film::volume_mm3(film::totals(film).thickness, film.cell_mm);
}

QImage WindowTest::picture() {
    settle();
    wait_for([this] { return canvas().finished(); });
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&canvas(), &leave);
    return canvas().picture().convertToFormat(QImage::Format_RGB888);
}

std::vector<glm::dvec2> line_mm(const glm::dvec2& from, const glm::dvec2& to, int steps) {
    std::vector<glm::dvec2> path;
    for (int i = 0; i <= steps; ++i)
        path.push_back(from + (to - from) * (static_cast<double>(i) / steps));
    return path;
}

PictureDifference difference(const QImage& a, const QImage& b) {
    EXPECT_EQ(a.size(), b.size());
    PictureDifference result;
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        const uchar* row_a = a.constScanLine(y);
        const uchar* row_b = b.constScanLine(y);
        for (int i = 0; i < 3 * a.width(); ++i) {
            const int apart = std::abs(row_a[i] - row_b[i]);
            result.largest = std::max(result.largest, apart);
            sum += apart;
        }
    }
    result.mean = sum / (3.0 * a.width() * a.height());
    return result;
}

}  // namespace pastoso::tests
