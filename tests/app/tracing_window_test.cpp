// The picture that is traced: below the paint of the window's canvas, and in a panel beside it.
#include "app/window_fixture.hpp"
#include "commands/command_registry.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"
#include "main/window_parts.hpp"
#include "panels/colour/picture_board.hpp"
#include "panels/layers/tracing_panel.hpp"
#include "pigment/hex_colour.hpp"

#include <QAction>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QTest>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;

class TracingWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::Pause)->trigger();
        // Left half blue, right half green.
        pigment::Picture picture{40, 20, {}};
        for (int i = 0; i < 800; ++i) {
            if (i % 40 < 20)
                picture.rgba.insert(picture.rgba.end(), {20, 40, 200, 255});
            else
                picture.rgba.insert(picture.rgba.end(), {30, 160, 40, 255});
        }
        core::write_text_file(path(), files::png_file(picture));
    }

    std::filesystem::path path() const { return folder.path() / "photo.png"; }
    void trace() {
        parts().tracing.trace_picture(QString::fromStdString(path().string()));
        loaded();
        settle();
    }
    auto tracing() {
        session().wait_until_applied();
        return session().snapshot()->tracing;
    }
    panels::PictureBoard& board() {
        return *window().findChild<panels::PictureBoard*>(QStringLiteral("tracing_board"));
    }
    QDoubleSpinBox& number(const char* name) {
        return *window().findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
    }
    /// Of the canvas's left and right half, a little above the middle.
    QColor seen(double share_of_width) {
        const document::CanvasSettings& canvas = session().canvas();
        const QImage shown = picture();
        const double ratio = this->canvas().devicePixelRatioF();
        const QPointF place =
            this->canvas().widget_position({share_of_width * canvas.width_mm, 0.5 * canvas.height_mm});
        return shown.pixelColor((ratio * place).toPoint());
    }
    void type(QDoubleSpinBox& box, const char* text) {
        box.setFocus(Qt::TabFocusReason);
        box.selectAll();
        QTest::keyClicks(&box, QString::fromLatin1(text));
        QTest::keyClick(&box, Qt::Key_Return);
    }

    TemporaryFolder folder;
};

TEST_F(TracingWindow, IsSeenBelowThePaintUntilItIsHidden) {
    const QColor bare = seen(0.25);
    trace();
    const QColor left = seen(0.25), right = seen(0.75);
    EXPECT_LT(left.red(), bare.red() - 30);
    EXPECT_GT(left.blue(), left.red() + 30);
    EXPECT_GT(right.green(), right.red() + 15);
    action(Command::ShowTracing)->trigger();
    EXPECT_EQ(seen(0.25), bare);
    action(Command::ShowTracing)->trigger();
    EXPECT_EQ(seen(0.25), left);
}

TEST_F(TracingWindow, ThickPaintCoversIt) {
    trace();
    const double height_mm = session().canvas().height_mm, width_mm = session().canvas().width_mm;
    const auto across = [&](double share) {
        return line_mm({share * width_mm - 5, 0.5 * height_mm}, {share * width_mm + 5, 0.5 * height_mm});
    };
    for (const double share : {0.25, 0.75})
        for (int times = 0; times < 4; ++times)
            mouse_stroke(across(share));
    const QColor left = seen(0.25), right = seen(0.75);
    EXPECT_LT(std::abs(left.blue() - right.blue()), 25);
    EXPECT_LT(std::abs(left.green() - right.green()), 25);
}

TEST_F(TracingWindow, IsInNoPictureThatIsSaved) {
    const auto saved = [&](const char* name) {
        const std::filesystem::path file = folder.path() / name;
        parts().exporting.start({}, file);
        wait_for([&] { return !parts().exporting.exporter().busy(); });
        return core::read_text_file(file);
    };
    const std::string before = saved("before.png");
    trace();
    EXPECT_EQ(saved("after.png"), before);
}

TEST_F(TracingWindow, OpacityIsPreviewedAndBecomesOneStepWhenTheSliderRests) {
    trace();
    const QColor half = seen(0.25);
    auto& slider = *window().findChild<QSlider*>(QStringLiteral("tracing_opacity_slider"));
    const auto changes = [&] { return session().status().changes; };
    const auto before = changes();
    for (const int step : {120, 150, 200})
        slider.setValue(step);
    const QColor whole = seen(0.25);
    EXPECT_LT(whole.red(), half.red() - 20);
    wait_for([&] { return tracing()->opacity == 1.0; });
    EXPECT_EQ(changes(), before + 1);
    EXPECT_EQ(seen(0.25), whole);
    action(Command::Undo)->trigger();
    EXPECT_EQ(seen(0.25), half);
    EXPECT_EQ(number("tracing_opacity").value(), 50.0);
}

TEST_F(TracingWindow, LiesWhereTheNumbersSayAndFitsAgain) {
    trace();
    const layers::PicturePlace fitted = tracing()->place;
    studio().commands().action(Command::TracingPanel)->trigger();
    type(number("tracing_x"), "-12.5");
    wait_for([&] { return tracing()->place.x_mm == -12.5; });
    type(number("tracing_width"), "20");
    wait_for([&] { return tracing()->place.width_mm == 20.0; });
    EXPECT_EQ(tracing()->place.height_mm, 10.0);
    EXPECT_EQ(tracing()->place.y_mm, fitted.y_mm);
    type(number("tracing_width"), "3 cm");
    wait_for([&] { return tracing()->place.width_mm == 30.0; });
    type(number("tracing_x"), "-1 in");
    wait_for([&] { return tracing()->place.x_mm == -25.4; });
    action(Command::FitTracing)->trigger();
    EXPECT_EQ(tracing()->place, fitted);
}

TEST_F(TracingWindow, AClickOnThePanelTakesPaintOfThatColour) {
    trace();
    action(Command::TracingPanel)->trigger();
    wait_for([&] { return board().isVisible() && board().width() > 0; });
    const auto click = [&](double share) {
        QTest::mouseClick(&board(), Qt::LeftButton, Qt::NoModifier,
                          QPoint(static_cast<int>(share * board().width()), board().height() / 2));
        return studio().easel().hand().paint.ingredients;
    };
    using testing::ElementsAre;
    EXPECT_THAT(click(0.25), ElementsAre(document::Ingredient{"#1428c8", 1.0}));
    EXPECT_THAT(click(0.75), ElementsAre(document::Ingredient{"#1ea028", 1.0}));
}

TEST_F(TracingWindow, ThePanelZoomsToThePointerAndFitsAgain) {
    trace();
    action(Command::TracingPanel)->trigger();
    wait_for([&] { return board().isVisible() && board().width() > 0; });
    const QPointF place(0.45 * board().width(), 0.5 * board().height());
    EXPECT_EQ(board().colour_at(place), QColor(20, 40, 200));
    const QPointF beside(0.55 * board().width(), 0.5 * board().height());
    EXPECT_EQ(board().colour_at(beside), QColor(30, 160, 40));
    board().zoom_about(place, 8.0);
    EXPECT_EQ(board().colour_at(place), QColor(20, 40, 200));
    board().zoom_about(place, 0.01);
    EXPECT_EQ(board().colour_at(beside), QColor(30, 160, 40));
}

TEST_F(TracingWindow, ComesBackWithThePaintingAndGoesWhenTakenAway) {
    trace();
    const auto before = tracing();
    const QString file = QString::fromStdString((folder.path() / "a.pastoso").string());
    parts().files.save_painting(file);
    ASSERT_EQ(parts().files.saver().wait().toStdString(), "");
    action(Command::RemoveTracing)->trigger();
    settle();
    EXPECT_EQ(tracing(), nullptr);
    EXPECT_FALSE(action(Command::FitTracing)->isEnabled());
    parts().files.open_painting(file);
    loaded();
    settle();
    ASSERT_TRUE(tracing());
    EXPECT_EQ(*tracing(), *before);
    EXPECT_TRUE(action(Command::FitTracing)->isEnabled());
}

TEST_F(TracingWindow, WhatIsNoPictureIsToldAndNothingChanges) {
    core::write_text_file(path(), "none");
    parts().tracing.trace_picture(QString::fromStdString(path().string()));
    loaded();
    ASSERT_THAT(studio().messages().standing(), testing::SizeIs(1));
    EXPECT_THAT(studio().messages().standing()[0].sentence.toStdString(),
                testing::HasSubstr("photo.png"));
    EXPECT_EQ(tracing(), nullptr);
}

}  // namespace
}  // namespace pastoso::tests
