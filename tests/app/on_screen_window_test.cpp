// What the windowing system has got of a canvas that the processor draws: all of it, though only what
// changes is sent.
#include "app/window_fixture.hpp"

#include <QAction>
#include <QApplication>
#include <QGuiApplication>
#include <QScreen>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class OnScreen : public WindowTest {
  protected:
    screen::DrawnBy drawn_by() const override { return screen::DrawnBy::Processor; }

    void SetUp() override {
        WindowTest::SetUp();
        if (QGuiApplication::platformName() != QStringLiteral("xcb"))
            GTEST_SKIP() << "nobody may look at this screen";
        action(Command::Pause)->trigger();
        studio().easel().take_brush("Flat bristle 20", 8.0);
        action(Command::LargerBrush)->trigger();  // shows the hand
    }

    QImage on_screen() {
        const QPoint corner = canvas().mapTo(&window(), QPoint(0, 0));
        return window()
            .screen()
            ->grabWindow(window().winId(), corner.x(), corner.y(), canvas().width(), canvas().height())
            .toImage()
            .convertToFormat(QImage::Format_RGB888);
    }

    /// The overlay, too, as it is now. Lines that are cut off at the edge of what is drawn anew are
    /// smoothed a level or two otherwise.
    void expect_all_there(const char* when) {
        constexpr int kSmoothing = 3;
        settle();
        wait_for([this] { return canvas().finished(); });
        const QImage wanted = canvas().picture().convertToFormat(QImage::Format_RGB888);
        int largest = 255;
        for (int i = 0; i < 100 && largest > kSmoothing; ++i) {
            QTest::qWait(10);
            largest = difference(on_screen(), wanted).largest;
        }
        EXPECT_LE(largest, kSmoothing) << when;
    }
};

TEST_F(OnScreen, StandsAllThatWasDrawn) {
    expect_all_there("bare");
    move({20.0, 15.0}, Qt::NoButton);
    expect_all_there("with the outline");
    mouse_stroke(line_mm({12.0, 10.0}, {46.0, 30.0}));
    expect_all_there("painted");
    press({15.0, 30.0});
    move({40.0, 12.0});
    expect_all_there("within a stroke");
    release({40.0, 12.0});
    canvas().pan({37.5, -11.0});
    expect_all_there("moved");
    mouse_stroke(line_mm({12.0, 30.0}, {46.0, 28.0}));
    canvas().turn_about_centre(13.0);
    expect_all_there("turned");
    action(Command::MirrorSymmetry)->trigger();
    expect_all_there("with a guide");
    action(Command::Undo)->trigger();
    expect_all_there("undone");
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&canvas(), &leave);
    expect_all_there("left by the pointer");
}

}  // namespace
}  // namespace pastoso::tests
