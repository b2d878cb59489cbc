// A pen of the X server, or of a Wayland compositor, from its driver to the painting: pressure, tilt,
// both ends, buttons, many events. Runs under with_tablet.sh, and under with_wayland.sh --tablet.
#include "app/latest_stroke.hpp"
#include "app/window_fixture.hpp"
#include "document/actions/actions.hpp"

#include <cmath>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>

#include <QAction>
#include <QApplication>
#include <QTest>

namespace pastoso::tests {
namespace {

/// An end of the pen, as its driver is told of it.
class PenEnd {
  public:
    explicit PenEnd(const char* end) {
        const char* folder = std::getenv("PASTOSO_TEST_TABLET");
        if (folder != nullptr) pipe_ = ::open((std::string(folder) + "/" + end).c_str(), O_WRONLY);
    }
    ~PenEnd() { ::close(pipe_); }
    PenEnd(const PenEnd&) = delete;
    PenEnd& operator=(const PenEnd&) = delete;

    bool is_there() const { return pipe_ >= 0; }
    void tell(const std::string& line) const {
        const std::string text = line + "\n";
        EXPECT_EQ(::write(pipe_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }

  private:
    int pipe_ = -1;
};

class TabletWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        ASSERT_TRUE(tip_.is_there() && eraser_.is_there())
            << "there is no tablet: with_tablet.sh and with_wayland.sh --tablet have one";
        action(commands::Command::Pause)->trigger();
        settle();
        wait_until_heard();
    }

    /// A compositor shows a window somewhat later than Qt says, and no pen is over it before.
    void wait_until_heard() {
        wait_for([&] {
            tip_.tell("near 1");
            tip_.tell(move({5.0, 35.0}, 0.0, 0.0, 0.0));  // no test waits for it there
            return canvas().pointer_mm().has_value();
        });
        tip_.tell("near 0");
    }

    std::string move(const glm::dvec2& mm, double pressure, double tilt_x_deg, double tilt_y_deg) {
        const QPointF place =
            canvas().mapToGlobal(canvas().widget_position(mm)) * canvas().devicePixelRatioF();
        std::string line = "move";
        for (const double value : {place.x(), place.y(), pressure, tilt_x_deg, tilt_y_deg})
            line += " " + std::to_string(value);
        return line;
    }

    static bool is_leaving_told() { return QGuiApplication::platformName() == "wayland"; }

    void wait_for_pointer_mm(double x_mm) {
        wait_for([&] {
            const auto pointer = canvas().pointer_mm();
            return pointer && std::abs(pointer->x - x_mm) < 0.2;
        });
    }

    void only_picks_paint(tools::PenButton button) {
        tools::PenSettings settings = canvas().pen();
        settings.buttons = {};
        settings.buttons[static_cast<std::size_t>(button)] = {tools::PenButtonDoes::PickPaint};
        canvas().set_pen(settings);
    }

    /// A line across the canvas, all values turning evenly from 0 to 1.
    void stroke(const PenEnd& end, int samples) {
        const auto at = [&](int i) {
            const double t = static_cast<double>(i) / samples;
            return move({10.0 + 40.0 * t, 20.0}, 0.1 + 0.8 * t, 40.0 * t, -30.0 * t);
        };
        const std::int64_t before = strokes();
        end.tell("near 1");
        end.tell(at(0));
        end.tell("tip 1");
        for (int i = 1; i <= samples; ++i)
            end.tell(at(i));
        end.tell("tip 0");
        end.tell("near 0");
        wait_for([&] { return strokes() > before && !studio().easel().painting(); });
    }
    std::int64_t strokes() {
        session().wait_until_applied();
        return session().status().strokes;
    }
    std::vector<brush::PenSample> latest_stroke() { return tests::latest_stroke(session()); }

    PenEnd tip_{"pen"}, eraser_{"eraser"};
};

TEST_F(TabletWindow, TheBrushIsPressedAndTiltedAsThePenIs) {
    stroke(tip_, 40);
    const std::vector<brush::PenSample> samples = latest_stroke();
    ASSERT_GT(samples.size(), 30U);
    for (const brush::PenSample& sample : samples) {
        const double t = (sample.x_mm - 10.0) / 40.0;
        // The screen's pixels are 0.1 mm; a tablet tells whole degrees.
        EXPECT_NEAR(sample.y_mm, 20.0, 0.1);
        EXPECT_NEAR(sample.pressure, 0.1 + 0.8 * t, 0.01);
        EXPECT_NEAR(sample.tilt_x_deg, 40.0 * t, 1.1);
        EXPECT_NEAR(sample.tilt_y_deg, -30.0 * t, 1.1);
    }
    EXPECT_NEAR(samples.back().x_mm, 50.0, 0.1);
    EXPECT_GT(volume_mm3(), 1.0);
}

TEST_F(TabletWindow, NoSampleIsLostWhereManyWaitAtOnce) {
    constexpr int kSamples = 1000;
    stroke(tip_, kSamples);
    EXPECT_GE(latest_stroke().size(), static_cast<std::size_t>(kSamples));
}

TEST_F(TabletWindow, TheOtherEndErasesAndTheTipPaintsAgain) {
    const std::string brush = studio().easel().hand().brush;
    stroke(tip_, 20);
    const double painted_mm3 = volume_mm3();
    stroke(eraser_, 20);
    EXPECT_EQ(studio().easel().hand().brush, canvas().pen().eraser_tool);
    EXPECT_LT(volume_mm3(), painted_mm3);
    stroke(tip_, 20);
    EXPECT_EQ(studio().easel().hand().brush, brush);
    EXPECT_EQ(strokes(), 3);
}

TEST_F(TabletWindow, APenInTheAirPaintsNothing) {
    tip_.tell("near 1");
    for (int i = 0; i < 20; ++i)
        tip_.tell(move({10.0 + i, 15.0}, 0.0, 0.0, 0.0));
    wait_for_pointer_mm(29.0);
    tip_.tell("near 0");
    if (is_leaving_told()) wait_for([&] { return !canvas().pointer_mm(); });
    EXPECT_EQ(strokes(), 0);
}

TEST_F(TabletWindow, AStrokeEndsWhereThePenLeavesBeforeItHasLifted) {
    if (!is_leaving_told()) GTEST_SKIP() << "on X11, Qt hears of it from the drivers of Wacom alone";
    tip_.tell("near 1");
    tip_.tell(move({10.0, 20.0}, 0.5, 0.0, 0.0));
    tip_.tell("tip 1");
    for (int i = 1; i <= 20; ++i)
        tip_.tell(move({10.0 + i, 20.0}, 0.5, 0.0, 0.0));
    wait_for_pointer_mm(30.0);
    EXPECT_TRUE(studio().easel().painting());
    tip_.tell("near 0");
    wait_for([&] { return !studio().easel().painting(); });
    tip_.tell("tip 0");
    stroke(tip_, 20);
    EXPECT_EQ(strokes(), 2);
}

TEST_F(TabletWindow, ItsButtonsAreTheLowerAndTheUpperOne) {
    stroke(tip_, 40);
    for (const auto& [button, number] :
         {std::pair(tools::PenButton::Lower, "2"), std::pair(tools::PenButton::Upper, "3")}) {
        only_picks_paint(button);
        studio().easel().choose_paint({{{"PR101", 1.0}}, 1.0});
        settle();
        tip_.tell("near 1");
        tip_.tell(move({30.0, 20.0}, 0.0, 0.0, 0.0));
        tip_.tell(std::string("button ") + number + " 1");
        wait_for([&] { return studio().easel().hand().paint.ingredients.front().pigment == "PB29"; });
        tip_.tell(std::string("button ") + number + " 0");
        tip_.tell("near 0");
    }
    EXPECT_EQ(strokes(), 1);
}

}  // namespace
}  // namespace pastoso::tests
