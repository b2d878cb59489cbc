// A tank of liquid in the window: it comes in place of the canvas or of the tea, and keys do what they
// say.
#include "core/text_file.hpp"
#include "document/painting_state.hpp"
#include "glass/glass_chooser.hpp"
#include "glass/liquid_picture_dialog.hpp"
#include "glass/tank_page.hpp"
#include "glass/tea_page.hpp"
#include "liquid_files/tank_json.hpp"
#include "main/liquids/tank_mode.hpp"
#include "main/liquids/tea_mode.hpp"
#include "main/window_parts.hpp"
#include "window_fixture.hpp"

#include <csignal>
#include <fstream>
#include <sys/resource.h>

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class TankWindow : public WindowTest {
  protected:
    QAction* action(Command command) { return studio().commands().action(command); }
    main::TankMode& tank() { return parts().tank; }
    session::TankSession& liquid() { return tank().session(); }
    glass::TankView& view() { return tank().page().view(); }

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
        core::write_text_file(file, liquid_files::tank_to_json(small_tank()));
        tank().open_scene(QString::fromStdString(file.string()));
        liquid().wait_until_applied();
        wait_for(
            [&] { return view().shown() != nullptr && view().shown()->seen.milk.shape().nx == 16; });
    }

    /// So small that a frame takes little without a graphics card.
    void make_view_small() {
        view().setFixedSize(320, 240);
        QApplication::processEvents();
    }

    void pause() {
        if (!liquid().status().paused) action(Command::LiquidPause)->trigger();
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

    void choose(glass::GlassChooser& chooser, const QString& item) {
        chooser.setCurrentIndex(chooser.findData(item));
        Q_EMIT chooser.activated(chooser.currentIndex());
    }

    QString folder() const { return QString::fromStdString(folder_.path().string()); }
    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

    TemporaryFolder folder_;
};

/// While it lives, no file of this process grows beyond that: as on a disk that is full.
class FileLimit {
  public:
    explicit FileLimit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
    FileLimit(const FileLimit&) = delete;
    FileLimit& operator=(const FileLimit&) = delete;

  private:
    rlimit before_{};
};

TEST_F(TankWindow, TheChooserGoesFromTeaToTankAndBack) {
    mouse_stroke(line_mm({15, 20}, {45, 20}, 10));
    action(Command::Pause)->trigger();
    settle();
    const std::uint64_t painted = document::state_hash(session().capture().painting);
    const QByteArray panels = window().saveState();
    action(Command::MilkTea)->trigger();
    main::TeaMode& tea = parts().tea;
    choose(tea.page().panel().chooser(), QStringLiteral("two-liquids"));
    EXPECT_FALSE(tea.page().isVisible());
    EXPECT_TRUE(tank().page().isVisible());
    EXPECT_FALSE(canvas().isVisible());
    EXPECT_FALSE(action(Command::MilkTea)->isChecked());
    EXPECT_TRUE(action(Command::GlassTank)->isChecked());
    EXPECT_EQ(tank().page().panel().chooser().choice(), QStringLiteral("two-liquids"));
    liquid().wait_until_applied();
    EXPECT_EQ(liquid().snapshot()->place->scene.name, "Two liquids");
    EXPECT_TRUE(tea.session().status().paused);
    choose(tank().page().panel().chooser(), glass::GlassChooser::tea_key());
    EXPECT_TRUE(tea.page().isVisible());
    EXPECT_FALSE(tank().page().isVisible());
    EXPECT_EQ(tea.page().panel().chooser().choice(), glass::GlassChooser::tea_key());
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
    EXPECT_EQ(liquid().snapshot()->place->scene.name, "Two liquids");
    key(Qt::Key_F6);
    EXPECT_EQ(liquid().snapshot()->place->scene.name, "Falling liquid");
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

TEST_F(TankWindow, StartingAgainKeepsWindAndDrain) {
    open_small_tank();
    key(Qt::Key_2);
    key(Qt::Key_3);
    key(Qt::Key_Left);
    wait_for([&] { return liquid().status().last_step > 2; });
    const session::TankStatus before = liquid().status();
    EXPECT_TRUE(before.drains_open);
    EXPECT_TRUE(before.wind.on);
    action(Command::TankRestart)->trigger();
    liquid().wait_until_applied();
    const session::TankStatus after = liquid().status();
    EXPECT_EQ(after.glass, before.glass + 1);
    EXPECT_EQ(after.wind, before.wind);
    EXPECT_TRUE(after.drains_open);
    QApplication::processEvents();
    EXPECT_TRUE(action(Command::TankWind)->isChecked());
    EXPECT_TRUE(action(Command::TankDrain)->isChecked());
}

TEST_F(TankWindow, WordsMoveTheNumbersBelow) {
    open_small_tank();
    const auto find = [&](const char* name) {
        return tank().page().findChild<QWidget*>(QString::fromLatin1(name));
    };
    auto* place = qobject_cast<QSlider*>(find("thin_to_thick"));
    auto* number = qobject_cast<QDoubleSpinBox*>(find("viscosity_m2_s"));
    ASSERT_NE(place, nullptr);
    ASSERT_NE(number, nullptr);
    EXPECT_FALSE(number->isVisible()) << "the numbers are folded";
    place->setValue(place->maximum());
    EXPECT_NEAR(number->value(), 5000.0, 1.0);
    number->setValue(1.0);
    EXPECT_EQ(place->value(), place->minimum());
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
    const auto& level_m = liquid().snapshot()->seen.level_m;
    EXPECT_LT(level_m.at(1 + 4, 1 + 8, 1 + 14), 0.0F);
    EXPECT_GT(level_m.at(1 + 12, 1 + 8, 1 + 14), 0.0F);
}

TEST_F(TankWindow, TheTimelineShowsAnyMoment) {
    open_small_tank();
    wait_for([&] { return liquid().status().last_step > 12; });
    auto* time = tank().page().findChild<QSlider*>(QStringLiteral("tank_time"));
    ASSERT_NE(time, nullptr);
    // Pictures come later than what is said: one of an early moment must be gone.
    wait_for([&] { return time->value() > 12 && view().shown()->seen.step > 12; });
    time->setValue(4);
    liquid().wait_until_applied();
    wait_for([&] { return view().shown() != nullptr && view().shown()->seen.step == 4; });
    EXPECT_TRUE(action(Command::LiquidPause)->isChecked());
    const int last = liquid().status().last_step;
    action(Command::LiquidPause)->trigger();
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

TEST_F(TankWindow, APictureIsRenderedAndBecomesALayer) {
    open_small_tank();
    key(Qt::Key_F8);
    glass::LiquidPictureDialog& dialog = tank().picture();
    EXPECT_TRUE(dialog.isVisible());
    dialog.findChild<QSpinBox*>(QStringLiteral("picture_width"))->setValue(32);
    dialog.findChild<QSpinBox*>(QStringLiteral("picture_height"))->setValue(24);
    dialog.findChild<QSpinBox*>(QStringLiteral("picture_samples"))->setValue(2);
    dialog.findChild<QPushButton*>(QStringLiteral("picture_start"))->click();
    liquid().wait_until_applied();
    EXPECT_TRUE(liquid().status().paused);
    wait_for([&] { return !dialog.rendering() && dialog.has_picture(); });
    dialog.save(QString::fromStdString(file("tank.png").string()));
    EXPECT_EQ(QImage(QString::fromStdString(file("tank.png").string())).size(), QSize(32, 24));
    const std::size_t layers = session().snapshot()->layers->layers.size();
    dialog.findChild<QPushButton*>(QStringLiteral("picture_use"))->click();
    EXPECT_FALSE(tank().active());
    settle();
    EXPECT_EQ(session().snapshot()->layers->layers.size(), layers + 1);
    EXPECT_EQ(told(), "");
}

/// Without a gap, however much faster the liquid would be.
TEST_F(TankWindow, PicturesAndSurfacesOfEveryStepAreWritten) {
    open_small_tank();
    make_view_small();
    std::ofstream(file("liquid_0006.png")) << "from before";
    action(Command::LiquidFullSpeed)->trigger();
    tank().record(main::Recorded::Pictures, folder());
    tank().record(main::Recorded::Surfaces, folder());
    const main::TankRecorder& recorder = tank().recorder();
    wait_for([&] { return recorder.written(main::Recorded::Pictures) >= 3; });
    action(Command::TankRecordPictures)->trigger();
    wait_for([&] { return !recorder.records(main::Recorded::Pictures); });
    EXPECT_THAT(told(), HasSubstr(" pictures are in " + folder_.path().string()));
    wait_for([&] { return recorder.written(main::Recorded::Surfaces) >= 5; });
    EXPECT_TRUE(action(Command::TankRecordSurfaces)->isChecked());
    action(Command::TankRecordSurfaces)->trigger();
    wait_for([&] { return !recorder.records(main::Recorded::Surfaces); });
    EXPECT_THAT(told(), HasSubstr(" surfaces are in " + folder_.path().string()));
    for (const char* name : {"liquid_0001.obj", "liquid_0005.obj", "liquid_0007.png", "liquid_0009.png"})
        EXPECT_GT(std::filesystem::file_size(file(name)), 1000U) << name;
    // What was there stays, and numbers go on after it.
    EXPECT_EQ(std::filesystem::file_size(file("liquid_0006.png")), 11U);
    const QImage picture(QString::fromStdString(file("liquid_0007.png").string()));
    EXPECT_EQ(picture.size(), view().grabFramebuffer().size());
    const int step = liquid().status().last_step;
    wait_for([&] { return liquid().status().last_step > step + 5; });
}

TEST_F(TankWindow, APictureOfTheViewHoldsTheMarks) {
    open_small_tank();
    make_view_small();
    pause();
    wait_for([&] { return view().finished(); });
    const QImage before = view().picture();
    action(Command::TankWind)->trigger();
    EXPECT_NE(view().picture(), before);
}

TEST_F(TankWindow, AFolderThatIsNoneEndsTheRecording) {
    open_small_tank();
    make_view_small();
    tank().record(main::Recorded::Pictures, folder() + QStringLiteral("/none"));
    EXPECT_TRUE(action(Command::TankRecordPictures)->isChecked());
    wait_for([&] { return !tank().recorder().records(main::Recorded::Pictures); });
    EXPECT_NE(told().find("none/liquid_0001.png: cannot be written"), std::string::npos) << told();
    EXPECT_FALSE(action(Command::TankRecordPictures)->isChecked());
    const int step = liquid().status().last_step;
    wait_for([&] { return liquid().status().last_step > step + 2; });
}

TEST_F(TankWindow, AFullDiskEndsTheRecordingAndWhatIsWrittenStays) {
    open_small_tank();
    tank().record(main::Recorded::Surfaces, folder());
    wait_for([&] { return tank().recorder().written(main::Recorded::Surfaces) >= 2; });
    {
        const FileLimit full(1000);
        wait_for([&] { return !tank().recorder().records(main::Recorded::Surfaces); });
    }
    EXPECT_NE(told().find(": cannot be written ("), std::string::npos) << told();
    EXPECT_FALSE(action(Command::TankRecordSurfaces)->isChecked());
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
        if (entry.path().extension() != ".json") {
            EXPECT_EQ(entry.path().extension(), ".obj") << entry.path();
            EXPECT_GT(entry.file_size(), 1000U) << entry.path();
        }
    EXPECT_TRUE(std::filesystem::exists(file("liquid_0002.obj")));
}

TEST_F(TankWindow, LeavingTheTankEndsTheRecording) {
    open_small_tank();
    tank().record(main::Recorded::Surfaces, folder());
    wait_for([&] { return tank().recorder().written(main::Recorded::Surfaces) >= 1; });
    action(Command::GlassTank)->trigger();
    wait_for([&] { return !tank().recorder().records(main::Recorded::Surfaces); });
    EXPECT_FALSE(action(Command::TankRecordSurfaces)->isChecked());
}

/// Liquid takes more of the red than of the blue light; the table before it is pale.
TEST_F(TankWindow, TheTankIsDrawn) {
    open_small_tank();
    make_view_small();
    pause();
    wait_for([&] { return view().finished(); });
    const QImage picture = view().grabFramebuffer();
    const double ratio = picture.width() / static_cast<double>(view().width());
    const QPointF place = ratio * view().camera().seen_at(glm::vec3(0.08F, 0.0F, 0.015F), view().size());
    const QColor seen = picture.pixelColor(place.toPoint());
    const QColor table = picture.pixelColor(QPoint(4, picture.height() - 4));
    EXPECT_GT(seen.blue(), seen.red() + 15) << seen.name().toStdString();
    EXPECT_GT(table.red(), table.blue() + 15) << table.name().toStdString();  // boards
    EXPECT_GT(table.red(), 150);
}

}  // namespace
}  // namespace pastoso::tests
