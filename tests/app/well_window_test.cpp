// The mixing well's panel: paint squeezed there is mixed by pen and mouse and carried to the canvas.
#include "app/window_fixture.hpp"
#include "document/player.hpp"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QTest>
#include <QToolButton>
#include <QWindow>

namespace pastoso::tests {
namespace {

using commands::Command;

class WellWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        give(Command::Pause);
    }

    void give(Command command) { studio().commands().action(command)->trigger(); }
    QDockWidget& panel() { return *window().findChild<QDockWidget*>(QStringLiteral("well_panel")); }
    void open_panel() {
        give(Command::MixingWell);
        wait_for([&] { return studio().well().finished(); });
    }
    void choose(const char* pigment) { studio().easel().choose_paint({{{pigment, 1.0}}, 1.0}); }

    /// What the panel shows of the latest state, in its final quality.
    QImage well_picture() {
        const double there_mm3 = in_well_mm3();
        wait_for([&] { return studio().well().finished() && shown_mm3() == there_mm3; });
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&studio().well(), &leave);
        return studio().well().picture().convertToFormat(QImage::Format_RGB888);
    }
    QColor well_colour(const glm::dvec2& place_mm) {
        const QImage picture = well_picture();
        const double ratio = studio().well().devicePixelRatioF();
        return picture.pixelColor((ratio * studio().well().widget_position(place_mm)).toPoint());
    }
    double shown_mm3() {
        const document::Snapshot* shown = studio().well().shown();
        if (shown == nullptr) return -1.0;
        return film::volume_mm3(film::totals(shown->film).thickness, shown->film.cell_mm);
    }
    /// Of a replay of what was recorded so far.
    document::Account account_after_replay() {
        session().wait_until_applied();
        const document::Recording recording = session().recording();
        core::ThreadPool pool(1);
        document::Painting painting(recording.canvas, pool);
        document::Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        return painting.account();
    }
    double in_well_mm3() {
        session().wait_until_applied();
        const auto snapshot = session().snapshot();
        if (!snapshot->well) return 0.0;
        return film::volume_mm3(film::totals(*snapshot->well).thickness, snapshot->well->cell_mm);
    }
};

TEST_F(WellWindow, IsClosedUntilItIsAskedForAndCostsNothing) {
    EXPECT_TRUE(panel().isHidden());
    EXPECT_FALSE(session().snapshot()->well.has_value());
    open_panel();
    EXPECT_TRUE(panel().isVisible());
    EXPECT_TRUE(studio().commands().action(Command::MixingWell)->isChecked());
    EXPECT_FALSE(session().snapshot()->well.has_value());
    panel().close();
    EXPECT_FALSE(studio().commands().action(Command::MixingWell)->isChecked());
}

TEST_F(WellWindow, SqueezedPaintIsSeenWhereItLies) {
    choose("PR108");
    give(Command::SqueezePaint);
    ASSERT_TRUE(panel().isVisible());
    EXPECT_GT(in_well_mm3(), 100.0);
    const QColor bare = well_colour({60.0, 60.0});
    EXPECT_LT(std::abs(bare.red() - bare.blue()), 20);
    const glm::dvec2 place_mm{60.0, 60.0};
    QTest::mouseClick(&studio().well(), Qt::LeftButton, Qt::ControlModifier,
                      studio().well().widget_position(place_mm).toPoint());
    EXPECT_GT(in_well_mm3(), 400.0);
    const QColor red = well_colour(place_mm);
    EXPECT_GT(red.red(), red.blue() + 80);
}

TEST_F(WellWindow, ThePenPicksUpThereAndCarriesToTheCanvas) {
    open_panel();
    choose("PR108");
    studio().easel().squeeze(60.0, 45.0);
    choose("PB29");
    give(Command::CleanBrush);
    const QImage before = well_picture();
    pen_stroke_on(studio().well(), line_mm({35.0, 45.0}, {75.0, 45.0}), {.pressure = 0.7});
    EXPECT_GT(difference(well_picture(), before).largest, 60);
    const double left_mm3 = in_well_mm3();
    EXPECT_LT(left_mm3, 240.0);
    EXPECT_EQ(volume_mm3(), 0.0);
    // "Reload each stroke" is on, and must not throw away what was mixed.
    pen_stroke({{10.0, 20.0}, {20.0, 20.0}, {30.0, 20.0}, {40.0, 20.0}}, {.pressure = 0.6});
    EXPECT_GT(volume_mm3(), 1.0);
    const document::Account account = account_after_replay();
    EXPECT_GT(account.canvas.pigment[0], 5.0 * account.canvas.pigment[5]) << "red, not ultramarine";
    EXPECT_EQ(in_well_mm3(), left_mm3);
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(WellWindow, AMouseStrokeThereIsUndone) {
    open_panel();
    studio().easel().squeeze(60.0, 45.0);
    const QImage before = well_picture();
    mouse_stroke_on(studio().well(), line_mm({35.0, 45.0}, {75.0, 45.0}));
    EXPECT_GT(difference(well_picture(), before).largest, 40);
    give(Command::Undo);
    EXPECT_EQ(difference(well_picture(), before).largest, 0);
    give(Command::CleanWell);
    EXPECT_EQ(in_well_mm3(), 0.0);
}

TEST_F(WellWindow, GrowsWithItsPanel) {
    open_panel();
    const auto paint_px = [this] {
        return studio().well().widget_position({120.0, 90.0}) -
               studio().well().widget_position({0.0, 0.0});
    };
    const auto fills_its_view = [&] {
        return studio().well().finished() && paint_px().x() > 0.9 * studio().well().width();
    };
    window().resizeDocks({&panel()}, {280}, Qt::Horizontal);
    wait_for([&] { return panel().width() < 300 && fills_its_view(); });
    const QPointF narrow = paint_px();
    window().resizeDocks({&panel()}, {420}, Qt::Horizontal);
    wait_for([&] { return panel().width() > 400 && fills_its_view(); });
    EXPECT_GT(paint_px().x(), 1.4 * narrow.x());
    EXPECT_GT(paint_px().y(), 1.4 * narrow.y());
}

TEST_F(WellWindow, TheBrushIsCleanedAndLoadedInIt) {
    open_panel();
    const auto click = [this](Command command) {
        QAction* action = studio().commands().action(command);
        for (auto* button : panel().findChildren<QToolButton*>())
            if (button->defaultAction() == action) return QTest::mouseClick(button, Qt::LeftButton);
        FAIL() << "no button for it";
    };
    const auto fill = [this] {
        session().wait_until_applied();
        return session().snapshot()->brush_load.fill;
    };
    click(Command::CleanBrush);
    EXPECT_EQ(fill(), 0.0);
    click(Command::ReloadBrush);
    EXPECT_GT(fill(), 0.9);
}

TEST_F(WellWindow, AFloatingPanelShowsTheSame) {
    open_panel();
    choose("PR108");
    studio().easel().squeeze(60.0, 45.0);
    EXPECT_GT(well_colour({60.0, 45.0}).red(), well_colour({60.0, 45.0}).blue() + 80);
    panel().setFloating(true);
    wait_until_shown(panel());
    EXPECT_GT(well_colour({60.0, 45.0}).red(), well_colour({60.0, 45.0}).blue() + 80);
    panel().setFloating(false);
    wait_until_shown(studio().well());
    EXPECT_GT(well_colour({60.0, 45.0}).red(), well_colour({60.0, 45.0}).blue() + 80);
}

}  // namespace
}  // namespace pastoso::tests
