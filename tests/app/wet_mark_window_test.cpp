// The wet mark: paint under the pen before the painting has heard of it.
#include "app/window_fixture.hpp"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QSignalBlocker>
#include <QTest>

namespace pastoso::tests {
namespace {

class MarkWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        action(commands::Command::Pause)->trigger();
        studio().easel().take_brush("Flat bristle 20", 8.0);
        studio().show_hand();
        settle();
    }

    void show_mark(bool at_once) {
        tools::PenSettings pen = canvas().pen();
        pen.wet_mark = at_once;
        canvas().set_pen(pen);
    }

    /// Of a stroke in progress that no snapshot shows.
    QImage frame_of_unshown_stroke() {
        const QSignalBlocker nothing_is_published(&studio());
        for (const glm::dvec2& mm : line_mm({12.0, 20.0}, {45.0, 22.0}, 30))
            pen_at(mm, Qt::LeftButton, {});
        return canvas().picture();
    }

    void lift() { pen_at({45.0, 22.0}, Qt::NoButton, {}); }

    QColor seen_at(const QImage& picture, const glm::dvec2& mm) {
        return picture.pixelColor((canvas().widget_position(mm) * picture.devicePixelRatio()).toPoint());
    }
};

TEST_F(MarkWindow, PaintIsUnderThePenBeforeThePaintingHasIt) {
    const QColor bare = seen_at(canvas().picture(), {25.0, 20.8});
    const QColor wet = seen_at(frame_of_unshown_stroke(), {25.0, 20.8});
    EXPECT_LT(wet.lightness(), bare.lightness() - 80);
    EXPECT_GT(wet.blue(), wet.red());
    lift();
}

TEST_F(MarkWindow, ItIsLikeThePaintThatTakesItsPlace) {
    const QImage before = frame_of_unshown_stroke();
    lift();
    const QImage after = picture();
    for (const double x_mm : {16.0, 22.0, 28.0, 34.0}) {
        const QColor mark = seen_at(before, {x_mm, 20.0 + 2.0 * (x_mm - 12.0) / 33.0});
        const QColor paint = seen_at(after, {x_mm, 20.0 + 2.0 * (x_mm - 12.0) / 33.0});
        // Grooves and light make paint lighter and darker than an even film.
        EXPECT_NEAR(mark.hueF(), paint.hueF(), 0.06) << x_mm;
        EXPECT_NEAR(mark.lightnessF(), paint.lightnessF(), 0.2) << x_mm;
    }
}

TEST_F(MarkWindow, NothingOfItIsLeft) {
    frame_of_unshown_stroke();
    lift();
    const QImage with = picture();
    show_mark(false);
    canvas().refresh();
    EXPECT_EQ(picture(), with);
}

TEST_F(MarkWindow, AnotherPaintingHasNoneOfIt) {
    frame_of_unshown_stroke();
    const QSignalBlocker nothing_is_published(&studio());
    const QImage with = canvas().picture();
    studio().on_canvas().paint.forget_posted();
    const QImage without = canvas().picture();
    EXPECT_LT(seen_at(with, {25.0, 20.8}).lightness(), seen_at(without, {25.0, 20.8}).lightness() - 80);
    lift();
}

TEST_F(MarkWindow, ItCanBeSwitchedOff) {
    show_mark(false);
    const QColor bare = seen_at(canvas().picture(), {25.0, 20.8});
    EXPECT_EQ(seen_at(frame_of_unshown_stroke(), {25.0, 20.8}), bare);
    lift();
}

TEST_F(MarkWindow, LooksOfAnotherColourHaveNone) {
    canvas().set_look(screen::Look::Normals);
    const QColor bare = seen_at(picture(), {25.0, 20.8});
    EXPECT_EQ(seen_at(frame_of_unshown_stroke(), {25.0, 20.8}), bare);
    lift();
}

TEST_F(MarkWindow, TheChoiceIsKept) {
    action(commands::Command::PenSettings)->trigger();
    auto* choice = window().findChild<QCheckBox*>(QStringLiteral("wet_mark"));
    ASSERT_NE(choice, nullptr);
    EXPECT_TRUE(choice->isChecked());
    choice->click();
    EXPECT_FALSE(canvas().pen().wet_mark);
    start_again();
    EXPECT_FALSE(canvas().pen().wet_mark);
}

}  // namespace
}  // namespace pastoso::tests
