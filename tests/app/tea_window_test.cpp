// Milk tea in the window: it comes in place of the canvas, and the painting waits.
#include "document/painting_state.hpp"
#include "glass/liquid_picture_dialog.hpp"
#include "glass/tea_page.hpp"
#include "liquid_files/tea_json.hpp"
#include "main/liquids/tank_mode.hpp"
#include "main/liquids/tea_mode.hpp"
#include "main/window_parts.hpp"
#include "panels/parts/gallery.hpp"
#include "window_fixture.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <glm/geometric.hpp>

namespace pastoso::tests {
namespace {

using commands::Command;

class TeaWindow : public WindowTest {
  protected:
    QAction* action(Command command) { return studio().commands().action(command); }
    main::TeaMode& tea() { return parts().tea; }
    session::TeaSession& glass() { return tea().session(); }
    glass::TeaView& view() { return tea().page().view(); }

    /// Enters the mode with a glass that a test can wait for.
    void enter_at_rest() {
        action(Command::MilkTea)->trigger();
        tea().page().panel().show_settings(small_glass());
        action(Command::TeaNewGlass)->trigger();
        glass().wait_until_applied();
        wait_for([&] { return view().shown() != nullptr && view().shown()->settings.cells == 16; });
    }

    /// The same, and pours the recipe.
    void enter() {
        enter_at_rest();
        action(Command::TeaPour)->trigger();
        glass().wait_until_applied();
    }

    static liquid::TeaSettings small_glass() {
        liquid::TeaSettings settings;
        settings.cells = 16;
        settings.parcels = 400;
        settings.pour_s = 0.1;
        return settings;
    }

    template <class Widget>
    Widget& find(const char* name) {
        auto* found = tea().page().findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }

    /// What stands over the view.
    std::string note() {
        QApplication::processEvents();
        const auto& label = find<QLabel>("canvas_note");
        return label.isVisible() ? label.text().toStdString() : "";
    }

    void pause() {
        if (!glass().status().paused) action(Command::LiquidPause)->trigger();
        glass().wait_until_applied();
        QApplication::processEvents();
    }

    void mouse(QEvent::Type type, const QPointF& place, Qt::MouseButton button,
               Qt::MouseButtons buttons) {
        QMouseEvent event(type, place, view().mapToGlobal(place), button, buttons, {});
        QApplication::sendEvent(&view(), &event);
    }

    void key(Qt::Key pressed) {
        QApplication::setActiveWindow(&window());
        view().setFocus();
        QTest::keyClick(&view(), pressed);
        glass().wait_until_applied();
    }
};

TEST_F(TeaWindow, ComesInPlaceOfTheCanvasAndGoesAgain) {
    mouse_stroke(line_mm({15, 20}, {45, 20}, 10));
    action(Command::Pause)->trigger();
    settle();
    const std::uint64_t painted = document::state_hash(session().capture().painting);
    const QByteArray panels = window().saveState();
    enter();
    EXPECT_TRUE(tea().page().isVisible());
    EXPECT_FALSE(canvas().isVisible());
    for (const QDockWidget* dock : window().findChildren<QDockWidget*>())
        EXPECT_FALSE(dock->isVisible()) << dock->objectName().toStdString();
    for (const QToolBar* bar : window().findChildren<QToolBar*>())
        EXPECT_FALSE(bar->isVisible());
    EXPECT_FALSE(action(Command::Undo)->isEnabled());
    EXPECT_TRUE(action(Command::TeaForce)->isEnabled());
    wait_for([&] { return glass().status().last_step > 5; });
    action(Command::MilkTea)->trigger();
    EXPECT_FALSE(tea().page().isVisible());
    EXPECT_TRUE(canvas().isVisible());
    EXPECT_EQ(window().saveState(), panels);
    EXPECT_TRUE(action(Command::Undo)->isEnabled());
    EXPECT_EQ(document::state_hash(session().capture().painting), painted);
    EXPECT_TRUE(session().status().paused);
}

/// As if it was paused, and goes on afterwards.
TEST_F(TeaWindow, WetPaintWaits) {
    mouse_stroke(line_mm({15, 20}, {45, 20}, 10));
    enter();
    session().capture();  // the tick that was being computed is over
    const std::int64_t tick = session().capture().painting.tick;
    wait_for([&] { return glass().status().last_step > 5; });
    EXPECT_EQ(session().capture().painting.tick, tick);
    action(Command::MilkTea)->trigger();
    EXPECT_FALSE(session().status().paused);
    wait_for([&] { return session().status().tick > tick; });
}

/// What stood there before comes back with the glass.
TEST_F(TeaWindow, TheGlassWaitsToo) {
    enter();
    wait_for([&] { return glass().status().last_step > 3; });
    action(Command::MilkTea)->trigger();
    glass().wait_until_applied();
    const int step = glass().status().last_step;
    EXPECT_TRUE(glass().status().paused);
    action(Command::MilkTea)->trigger();
    wait_for([&] { return glass().status().last_step > step; });
    EXPECT_EQ(glass().status().glass, 2);
}

TEST_F(TeaWindow, OpensAtRestWithPourInSight) {
    action(Command::MilkTea)->trigger();
    wait_for([&] { return view().shown() != nullptr; });
    glass().wait_until_applied();
    EXPECT_TRUE(glass().status().at_rest);
    EXPECT_FALSE(glass().status().paused);
    EXPECT_EQ(glass().status().last_step, 0);
    EXPECT_EQ(view().shown()->settings.parcels, glass::kLiveParcels);
    EXPECT_EQ(note(), "Press on the tea to pour milk where you point");
    EXPECT_FALSE(action(Command::TeaPour)->isChecked());
    for (const QAction* shown : {action(Command::TeaPour), action(Command::TeaForce)}) {
        const auto buttons = tea().page().panel().findChildren<QToolButton*>();
        const auto button = std::ranges::find(buttons, shown, &QToolButton::defaultAction);
        ASSERT_NE(button, buttons.end());
        EXPECT_FALSE((*button)->visibleRegion().isEmpty()) << shown->text().toStdString();
    }
    EXPECT_FALSE(find<QDoubleSpinBox>("viscosity_m2_s").isVisible()) << "the numbers are folded";
}

TEST_F(TeaWindow, PourPoursTheRecipeAndStops) {
    enter_at_rest();
    action(Command::TeaPour)->trigger();
    wait_for([&] { return glass().status().milk_m3 > 0.99 * small_glass().milk_m3; });
    wait_for([&] { return !action(Command::TeaPour)->isChecked(); });
    liquid::TeaSettings longer = small_glass();
    longer.pour_s = 1000.0;
    tea().page().panel().show_settings(longer);
    action(Command::TeaNewGlass)->trigger();
    action(Command::TeaPour)->trigger();
    wait_for([&] { return glass().status().last_step > 3 && action(Command::TeaPour)->isChecked(); });
    action(Command::TeaPour)->trigger();
    glass().wait_until_applied();
    EXPECT_FALSE(glass().status().recipe_flows);
}

TEST_F(TeaWindow, ARecipeIsPouredByItsPicture) {
    enter_at_rest();
    auto& recipes = find<panels::Gallery>("tea_recipes");
    ASSERT_EQ(static_cast<std::size_t>(recipes.count()), liquid_files::bundled_tea_names().size());
    const std::vector<glass::TeaRecipe> all = glass::tea_recipes();
    const auto cream = std::ranges::find(all, QStringLiteral("cream"), &glass::TeaRecipe::scene);
    ASSERT_NE(cream, all.end());
    const int number = static_cast<int>(cream - all.begin());
    EXPECT_FALSE(recipes.model()->index(number, 0).data(Qt::DecorationRole).value<QPixmap>().isNull());
    pause();
    QTest::mouseClick(recipes.viewport(), Qt::LeftButton, {}, recipes.middle(number));
    wait_for([&] { return glass().status().milk_m3 > 0.0; });
    EXPECT_FALSE(glass().status().paused);
    EXPECT_EQ(glass().snapshot()->settings.fat_m_s2, liquid_files::read_tea("cream").fat_m_s2);
    EXPECT_EQ(told(), "");
}

TEST_F(TeaWindow, WordsMoveTheNumbersBelow) {
    enter_at_rest();
    auto& place = find<QSlider>("warm_to_cold");
    const double usual = small_glass().cold_m_s2;
    place.setValue(place.maximum());
    glass().wait_until_applied();
    const double coldest = glass().snapshot()->settings.cold_m_s2;
    EXPECT_GT(coldest, usual);
    EXPECT_NEAR(find<QDoubleSpinBox>("cold_m_s2").value(), coldest, 0.006);
    place.setValue(place.minimum());
    glass().wait_until_applied();
    EXPECT_LT(glass().snapshot()->settings.cold_m_s2, liquid::TeaSettings{}.fat_m_s2) << "it floats";
    EXPECT_EQ(glass().status().glass, 2) << "the glass stays";
    find<QDoubleSpinBox>("cold_m_s2").setValue(usual);
    EXPECT_NEAR(place.value(), 0.5 * place.maximum(), 0.02 * place.maximum());
}

TEST_F(TeaWindow, APauseIsSeenAndPouringEndsIt) {
    enter();
    EXPECT_EQ(note(), "");
    pause();
    EXPECT_EQ(note(), "Paused");
    EXPECT_TRUE(std::ranges::any_of(
        tea().page().findChildren<QLabel*>(QStringLiteral("reading")),
        [](const QLabel* label) { return label->text().endsWith(QStringLiteral("paused")); }));
    const double before_m3 = glass().status().milk_m3;
    const QPointF place = view().widget_position({0.05F, 0.05F});
    mouse(QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
    wait_for([&] { return glass().status().milk_m3 > before_m3; });
    mouse(QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
    // On a slow machine the small glass may have become full meanwhile, which is told while one pours.
    wait_for([&] { return note().empty(); });
    EXPECT_EQ(note(), "");
    EXPECT_FALSE(action(Command::LiquidPause)->isChecked());
}

TEST_F(TeaWindow, TheTitleSaysWhereOneIs) {
    const QString painting = window().windowTitle();
    enter();
    EXPECT_EQ(window().windowTitle(), QStringLiteral("Milk tea - ") + painting);
    action(Command::GlassTank)->trigger();
    EXPECT_EQ(window().windowTitle(), QStringLiteral("Glass tank - ") + painting);
    action(Command::GlassTank)->trigger();
    EXPECT_EQ(window().windowTitle(), painting);
}

/// Threads of this process.
std::size_t threads() {
    const std::filesystem::directory_iterator all("/proc/self/task");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

TEST_F(TeaWindow, NothingOfLiquidsIsThereWhileOnePaints) {
    mouse_stroke(line_mm({15, 20}, {45, 20}, 10));
    settle();
    const std::size_t painting = threads();
    EXPECT_TRUE(window().findChildren<glass::GlassPage*>().empty());
    EXPECT_FALSE(tea().ready());
    EXPECT_FALSE(parts().tank.ready());
    action(Command::MilkTea)->trigger();
    EXPECT_TRUE(tea().ready());
    EXPECT_FALSE(parts().tank.ready());
    EXPECT_EQ(window().findChildren<glass::GlassPage*>().size(), 1);
    EXPECT_GT(threads(), painting) << "the liquid's threads begin with it";
}

TEST_F(TeaWindow, APressOnTheTeaPours) {
    enter();
    wait_for([&] { return glass().status().last_s > 0.3; });
    const double before_m3 = glass().status().milk_m3;
    const QPointF place = view().widget_position({0.05F, 0.045F});
    mouse(QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
    glass().wait_until_applied();
    EXPECT_TRUE(glass().status().pouring);
    wait_for([&] { return glass().status().milk_m3 > before_m3 + 1e-7; });
    mouse(QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
    glass().wait_until_applied();
    EXPECT_FALSE(glass().status().pouring);
    wait_for([&] { return glass().snapshot()->seen.pour.streams.empty(); });
    pause();
    const double poured_m3 = glass().status().milk_m3;
    action(Command::LiquidPause)->trigger();
    const int step = glass().status().last_step;
    wait_for([&] { return glass().status().last_step > step + 3; });
    EXPECT_EQ(glass().status().milk_m3, poured_m3);
}

TEST_F(TeaWindow, MilkFallsWhereOnePoints) {
    enter_at_rest();
    const glm::vec2 at_m(0.065F, 0.045F);
    const QPointF place = view().widget_position(at_m);
    mouse(QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
    mouse(QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
    glass().wait_until_applied();
    pause();
    const auto snapshot = glass().snapshot();
    ASSERT_FALSE(snapshot->seen.parcels.empty());
    for (const liquid::Parcel& parcel : snapshot->seen.parcels)
        EXPECT_LT(glm::distance(glm::vec2(parcel.position_m), at_m),
                  1.5F * static_cast<float>(snapshot->settings.pour_radius_m));
}

TEST_F(TeaWindow, APenPoursToo) {
    enter();
    wait_for([&] { return glass().status().last_s > 0.3; });
    const double before_m3 = glass().status().milk_m3;
    const QPointF place = view().widget_position({0.05F, 0.05F});
    pen_over(view(), place, Qt::LeftButton, {});
    wait_for([&] { return glass().status().milk_m3 > before_m3; });
    pen_over(view(), place, Qt::NoButton, {.pressure = 0.0});
    glass().wait_until_applied();
    EXPECT_FALSE(glass().status().pouring);
}

TEST_F(TeaWindow, TheOtherButtonsTurnTheGlass) {
    enter();
    const glass::GlassCamera before = view().camera();
    const QPointF place = view().widget_position({0.05F, 0.05F});
    mouse(QEvent::MouseButtonPress, place, Qt::RightButton, Qt::RightButton);
    mouse(QEvent::MouseMove, place + QPointF(60, 20), Qt::NoButton, Qt::RightButton);
    mouse(QEvent::MouseButtonRelease, place + QPointF(60, 20), Qt::RightButton, Qt::NoButton);
    EXPECT_NE(view().camera(), before);
    EXPECT_FALSE(glass().status().pouring);
    action(Command::LiquidFrontView)->trigger();
    EXPECT_EQ(view().camera(), before);
}

TEST_F(TeaWindow, KeysStirPauseAndMoveTheAxis) {
    enter();
    key(Qt::Key_S);
    EXPECT_TRUE(glass().status().force.on);
    const session::TeaForce first = glass().status().force;
    key(Qt::Key_F3);
    EXPECT_EQ(glass().status().force.swirl_rad_s2, -first.swirl_rad_s2);
    key(Qt::Key_Right);
    key(Qt::Key_Up);
    const glm::dvec2 moved = glass().status().force.axis_m - first.axis_m;
    EXPECT_GT(glm::dot(moved, glm::dvec2(view().camera().right())), 1e-3);
    EXPECT_GT(glm::dot(moved, glm::dvec2(view().camera().forward())), 1e-3);
    key(Qt::Key_Left);
    key(Qt::Key_Down);
    EXPECT_NEAR(glm::length(glass().status().force.axis_m - first.axis_m), 0.0, 1e-9);
    key(Qt::Key_Left);
    key(Qt::Key_F2);
    EXPECT_EQ(glass().status().force.axis_m, first.axis_m);
    key(Qt::Key_F4);
    EXPECT_TRUE(glass().status().paused);
    key(Qt::Key_F4);
    EXPECT_FALSE(glass().status().paused);
    key(Qt::Key_S);
    EXPECT_FALSE(glass().status().force.on);
}

TEST_F(TeaWindow, OneKeyMeansOneThingInEachMode) {
    const commands::KeyBindings& keys = studio().commands().keys();
    EXPECT_EQ(keys.holder(QKeySequence("F4"), commands::Mode::Painting), Command::LightPanel);
    EXPECT_EQ(keys.holder(QKeySequence("F4"), commands::Mode::Tea), Command::LiquidPause);
    EXPECT_FALSE(action(Command::LiquidPause)->isEnabled());
    EXPECT_TRUE(action(Command::LightPanel)->isEnabled());
    enter();
    EXPECT_TRUE(action(Command::LiquidPause)->isEnabled());
    EXPECT_FALSE(action(Command::LightPanel)->isEnabled());
    EXPECT_FALSE(action(Command::LightPanel)->isVisible());
}

TEST_F(TeaWindow, TheSurfaceIsExported) {
    enter();
    wait_for([&] { return glass().status().last_s > 0.3; });
    pause();
    const TemporaryFolder folder;
    const auto file = folder.path() / "milk_0001.pbrt";
    tea().export_mesh(QString::fromStdString(file.string()));
    wait_for([&] { return !tea().exporting(); });
    wait_for([&] { return told().find("milk_0001.pbrt") != std::string::npos; });
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    EXPECT_NE(text.str().find("trianglemesh"), std::string::npos) << text.str().substr(0, 200);
    EXPECT_THROW(tea().export_mesh(QStringLiteral("milk.doc")), std::runtime_error);
}

TEST_F(TeaWindow, TheTimelineShowsAnyMoment) {
    enter();
    wait_for([&] { return glass().status().last_step > 12; });
    auto* time = tea().page().findChild<QSlider*>(QStringLiteral("tea_time"));
    ASSERT_NE(time, nullptr);
    // Pictures come later than what is said: one of an early moment must be gone.
    wait_for([&] { return time->value() > 12 && view().shown()->seen.step > 12; });
    time->setValue(4);
    glass().wait_until_applied();
    wait_for([&] { return view().shown() != nullptr && view().shown()->seen.step == 4; });
    EXPECT_TRUE(action(Command::LiquidPause)->isChecked());
    EXPECT_EQ(time->value(), 4);
    const int last = glass().status().last_step;
    action(Command::LiquidPause)->trigger();
    wait_for([&] { return glass().status().last_step > last; });
}

TEST_F(TeaWindow, ScenesAreSavedAndOpened) {
    enter();
    const TemporaryFolder folder;
    const QString file = QString::fromStdString((folder.path() / "glass.json").string());
    key(Qt::Key_S);
    tea().save_scene(file);
    tea().page().panel().show_settings({});
    key(Qt::Key_S);
    tea().open_scene(file);
    glass().wait_until_applied();
    EXPECT_EQ(glass().snapshot()->settings.cells, 16);
    EXPECT_TRUE(glass().status().force.on);
    EXPECT_EQ(tea().page().panel().settings().parcels, 400);
    EXPECT_THROW(tea().open_scene(QStringLiteral("/nowhere.json")), std::runtime_error);
}

TEST_F(TeaWindow, APictureIsRenderedAndBecomesALayer) {
    enter();
    wait_for([&] { return glass().status().last_step > 3; });
    action(Command::TeaRender)->trigger();
    glass::LiquidPictureDialog& dialog = tea().picture();
    EXPECT_TRUE(dialog.isVisible());
    dialog.findChild<QSpinBox*>(QStringLiteral("picture_width"))->setValue(32);
    dialog.findChild<QSpinBox*>(QStringLiteral("picture_height"))->setValue(24);
    dialog.findChild<QSpinBox*>(QStringLiteral("picture_samples"))->setValue(2);
    dialog.findChild<QPushButton*>(QStringLiteral("picture_start"))->click();
    wait_for([&] { return !dialog.rendering() && dialog.has_picture(); });
    const TemporaryFolder folder;
    for (const char* name : {"tea.png", "tea.exr"}) {
        const auto file = folder.path() / name;
        dialog.save(QString::fromStdString(file.string()));
        EXPECT_GT(std::filesystem::file_size(file), 100U) << name;
    }
    const std::size_t layers = session().snapshot()->layers->layers.size();
    dialog.findChild<QPushButton*>(QStringLiteral("picture_use"))->click();
    EXPECT_FALSE(tea().active());
    settle();
    EXPECT_EQ(session().snapshot()->layers->layers.size(), layers + 1);
    EXPECT_EQ(told(), "");
}

TEST_F(TeaWindow, TheGlassIsDrawn) {
    enter();
    pause();
    wait_for([&] { return view().finished(); });
    const QImage picture = view().grabFramebuffer();
    // Tea is brown, the boards before it are pale.
    const QPointF ratio(picture.width() / static_cast<double>(view().width()),
                        picture.height() / static_cast<double>(view().height()));
    const QPointF middle(0.5 * view().width() * ratio.x(), 0.5 * view().height() * ratio.y());
    const QColor tea_colour = picture.pixelColor(middle.toPoint());
    const QColor table = picture.pixelColor(QPoint(4, picture.height() - 4));
    EXPECT_GT(tea_colour.red(), tea_colour.blue() + 60);
    EXPECT_GT(table.blue(), tea_colour.blue() + 60);
    EXPECT_GT(table.red(), 180);
}

/// What the hand would do is seen in it as on the screen.
TEST_F(TeaWindow, APictureOfTheWindowHasTheMarks) {
    enter();
    pause();
    wait_for([&] { return view().finished(); });
    const QImage bare = view().grabFramebuffer();
    mouse(QEvent::MouseMove, view().widget_position({0.05F, 0.05F}), Qt::NoButton, Qt::NoButton);
    const QImage marked = view().grabFramebuffer();
    EXPECT_GT(difference(marked.convertToFormat(QImage::Format_RGB888),
                         bare.convertToFormat(QImage::Format_RGB888))
                  .largest,
              20);
    EXPECT_EQ(view().grab().toImage().convertToFormat(QImage::Format_RGB888),
              marked.convertToFormat(QImage::Format_RGB888));
}

}  // namespace
}  // namespace pastoso::tests
