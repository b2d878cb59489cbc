// A tank of liquid in the window: it comes in place of the canvas or of the tea, and keys do what they
// say.
#include "core/text_file.hpp"
#include "document/painting_state.hpp"
#include "io/tank_json.hpp"
#include "main/tank_mode.hpp"
#include "main/tea_mode.hpp"
#include "tea/glass_chooser.hpp"
#include "tea/tank_page.hpp"
#include "tea/tea_page.hpp"
#include "window_fixture.hpp"

#include <QAction>
#include <QApplication>
#include <QSlider>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class TankWindow : public WindowTest {
  protected:
    QAction* action(Command command) { return window().commands().action(command); }
    main::TankMode& tank() { return window().tank(); }
    session::TankSession& liquid() { return tank().session(); }
    tea::TankView& view() { return tank().page().view(); }

    /// A quarter full, and so small that a test can wait for it.
    static tank::TankScene small_tank() {
        tank::TankScene scene;
        scene.cells = {16, 16, 16};
        scene.cell_m = 0.01;
        scene.liquids.push_back(
            {.shape = {tank::Block{glm::vec3(-0.1F), glm::vec3(0.3F, 0.3F, 0.04F)}}});
        return scene;
    }

    void open_small_tank() {
        const auto file = folder_.path() / "small.json";
        core::write_text_file(file, io::tank_to_json(small_tank()));
        tank().open_scene(QString::fromStdString(file.string()));
        liquid().wait_until_applied();
        wait_for(
            [&] { return view().shown() != nullptr && view().shown()->seen.milk.shape().nx == 16; });
    }

    void pause() {
        if (!liquid().status().paused) action(Command::TeaPause)->trigger();
        liquid().wait_until_applied();
        QApplication::processEvents();
    }

    void key(Qt::Key pressed) {
        QApplication::setActiveWindow(&window());
        view().setFocus();
        QTest::keyClick(&view(), pressed);
        liquid().wait_until_applied();
        QApplication::processEvents();
    }

    void choose(tea::GlassChooser& chooser, const QString& item) {
        chooser.setCurrentIndex(chooser.findData(item));
        Q_EMIT chooser.activated(chooser.currentIndex());
    }

    TemporaryFolder folder_;
};

TEST_F(TankWindow, TheChooserGoesFromTeaToTankAndBack) {
    mouse_stroke(line_mm({15, 20}, {45, 20}, 10));
    action(Command::Pause)->trigger();
    settle();
    const std::uint64_t painted = document::state_hash(session().capture().painting);
    const QByteArray panels = window().saveState();
    action(Command::MilkTea)->trigger();
    main::TeaMode& tea = window().tea();
    choose(tea.page().panel().chooser(), QStringLiteral("two-liquids"));
    EXPECT_FALSE(tea.page().isVisible());
    EXPECT_TRUE(tank().page().isVisible());
    EXPECT_FALSE(canvas().isVisible());
    EXPECT_FALSE(action(Command::MilkTea)->isChecked());
    EXPECT_TRUE(action(Command::GlassTank)->isChecked());
    EXPECT_EQ(tank().page().panel().chooser().choice(), QStringLiteral("two-liquids"));
    liquid().wait_until_applied();
    EXPECT_EQ(liquid().moment()->place->scene.name, "Two liquids");
    EXPECT_TRUE(tea.session().status().paused);
    choose(tank().page().panel().chooser(), tea::GlassChooser::tea_key());
    EXPECT_TRUE(tea.page().isVisible());
    EXPECT_FALSE(tank().page().isVisible());
    EXPECT_EQ(tea.page().panel().chooser().choice(), tea::GlassChooser::tea_key());
    liquid().wait_until_applied();
    EXPECT_TRUE(liquid().status().paused);
    tea.session().wait_until_applied();
    EXPECT_FALSE(tea.session().status().paused);
    action(Command::MilkTea)->trigger();
    EXPECT_TRUE(canvas().isVisible());
    EXPECT_EQ(window().saveState(), panels);
    EXPECT_EQ(document::state_hash(session().capture().painting), painted);
    EXPECT_TRUE(action(Command::Undo)->isEnabled());
}

TEST_F(TankWindow, ComesInPlaceOfTheCanvasAndGoesAgain) {
    open_small_tank();
    EXPECT_TRUE(tank().active());
    EXPECT_FALSE(canvas().isVisible());
    EXPECT_TRUE(action(Command::TankWind)->isEnabled());
    EXPECT_FALSE(action(Command::TeaForce)->isEnabled());
    EXPECT_FALSE(action(Command::Undo)->isVisible());
    wait_for([&] { return liquid().status().last_step > 2; });
    action(Command::GlassTank)->trigger();
    EXPECT_TRUE(canvas().isVisible());
    liquid().wait_until_applied();
    const int step = liquid().status().last_step;
    EXPECT_TRUE(liquid().status().paused);
    action(Command::GlassTank)->trigger();
    wait_for([&] { return liquid().status().last_step > step; });
}

TEST_F(TankWindow, KeysChooseAndPause) {
    open_small_tank();
    key(Qt::Key_F4);
    EXPECT_TRUE(liquid().status().paused);
    key(Qt::Key_F7);
    EXPECT_EQ(liquid().moment()->place->scene.name, "Two liquids");
    key(Qt::Key_F6);
    EXPECT_EQ(liquid().moment()->place->scene.name, "Falling liquid");
    EXPECT_EQ(tank().page().panel().chooser().choice(), QStringLiteral("falling-liquid"));
}

TEST_F(TankWindow, KeysAddBallsOpenTheDrainAndTurnTheWind) {
    open_small_tank();
    pause();
    const double before_m3 = liquid().status().volume_m3;
    key(Qt::Key_1);
    EXPECT_GT(liquid().status().volume_m3, before_m3 + 1e-6);
    EXPECT_FALSE(liquid().status().drains_open);
    key(Qt::Key_2);
    EXPECT_TRUE(liquid().status().drains_open);
    key(Qt::Key_2);
    EXPECT_FALSE(liquid().status().drains_open);
    key(Qt::Key_3);
    EXPECT_TRUE(liquid().status().wind.on);
    key(Qt::Key_Left);
    EXPECT_EQ(liquid().status().wind.direction_deg, 15.0);
    key(Qt::Key_Right);
    key(Qt::Key_Right);
    EXPECT_EQ(liquid().status().wind.direction_deg, -15.0);
    const double speed_m_s = liquid().status().wind.speed_m_s;
    key(Qt::Key_Up);
    EXPECT_EQ(liquid().status().wind.speed_m_s, speed_m_s + 0.5);
    key(Qt::Key_Down);
    key(Qt::Key_3);
    EXPECT_FALSE(liquid().status().wind.on);
    key(Qt::Key_F3);
    EXPECT_TRUE(view().velocity_shown());
    key(Qt::Key_F3);
    EXPECT_FALSE(view().velocity_shown());
}

TEST_F(TankWindow, APressOnTheLiquidLetsABallFall) {
    open_small_tank();
    pause();
    const double before_m3 = liquid().status().volume_m3;
    const QPointF place = view().widget_position({0.04F, 0.08F});
    for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
        QMouseEvent event(type, place, view().mapToGlobal(place), Qt::LeftButton,
                          type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, {});
        QApplication::sendEvent(&view(), &event);
    }
    liquid().wait_until_applied();
    EXPECT_GT(liquid().status().volume_m3, before_m3 + 1e-6);
    // Where it was pressed, and at the top.
    const auto& level_m = liquid().moment()->seen.level_m;
    EXPECT_LT(level_m.at(1 + 4, 1 + 8, 1 + 14), 0.0F);
    EXPECT_GT(level_m.at(1 + 12, 1 + 8, 1 + 14), 0.0F);
}

TEST_F(TankWindow, TheTimelineShowsAnyMoment) {
    open_small_tank();
    wait_for([&] { return liquid().status().last_step > 12; });
    auto* time = tank().page().findChild<QSlider*>(QStringLiteral("tank_time"));
    ASSERT_NE(time, nullptr);
    wait_for([&] { return time->value() > 12; });
    time->setValue(4);
    liquid().wait_until_applied();
    wait_for([&] { return view().shown() != nullptr && view().shown()->seen.step == 4; });
    EXPECT_TRUE(action(Command::TeaPause)->isChecked());
    const int last = liquid().status().last_step;
    action(Command::TeaPause)->trigger();
    wait_for([&] { return liquid().status().last_step > last; });
}

TEST_F(TankWindow, SurfacesAreExported) {
    open_small_tank();
    wait_for([&] { return liquid().status().last_step > 3; });
    pause();
    const auto file = folder_.path() / "one.ply";
    tank().export_mesh(QString::fromStdString(file.string()));
    wait_for([&] { return told().find("one.ply") != std::string::npos; });
    EXPECT_GT(std::filesystem::file_size(file), 1000U);
    tank().export_all(QString::fromStdString(folder_.path().string()));
    wait_for([&] { return told().find("All surfaces") != std::string::npos; });
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
        found += entry.path().extension() == ".obj" ? 1 : 0;
    EXPECT_EQ(found, liquid().status().kept.size());
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "liquid_0001.obj"));
    EXPECT_THROW(tank().export_mesh(QStringLiteral("liquid.doc")), std::runtime_error);
}

/// Liquid takes more of the red than of the blue light; the table before it is pale.
TEST_F(TankWindow, TheTankIsDrawn) {
    open_small_tank();
    pause();
    wait_for([&] { return view().finished(); });
    const QImage picture = view().grabFramebuffer();
    const double ratio = picture.width() / static_cast<double>(view().width());
    const QPointF place = ratio * view().camera().seen_at(glm::vec3(0.08F, 0.0F, 0.015F), view().size());
    const QColor seen = picture.pixelColor(place.toPoint());
    const QColor table = picture.pixelColor(QPoint(4, picture.height() - 4));
    EXPECT_GT(seen.blue(), seen.red() + 15) << seen.name().toStdString();
    EXPECT_LT(std::abs(table.red() - table.blue()), 40);
    EXPECT_GT(table.red(), 150);
}

}  // namespace
}  // namespace pastoso::tests
