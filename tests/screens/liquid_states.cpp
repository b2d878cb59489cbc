#include "appearance/theme.hpp"
#include "glass/liquid_picture_dialog.hpp"
#include "glass/tank_page.hpp"
#include "glass/tea_page.hpp"
#include "main/liquids/tank_mode.hpp"
#include "main/liquids/tea_mode.hpp"
#include "main/window_parts.hpp"
#include "states.hpp"

#include <QAction>
#include <QApplication>
#include <QPainter>
#include <QPushButton>

namespace pastoso::screens {
namespace {

using commands::Command;

/// Lets the liquid's time pass until then, and waits for the view's final frame.
template <class Mode>
void wait_for_liquid(Camera& camera, Mode& mode, double until_s, const QString& name) {
    mode.session().set_paused(false);
    mode.session().set_full_speed(true);
    // A second takes a few on a small machine, and of a tank many.
    constexpr double kPart_s = 0.1;
    for (double part_s = kPart_s; part_s < until_s + 0.5 * kPart_s; part_s += kPart_s)
        if (!wait_for([&] { return mode.session().status().last_s >= part_s; }))
            return camera.complain(name);
    mode.session().set_paused(true);
    mode.session().wait_until_applied();
    pass_time();
    wait_for([&] { return mode.page().view().finished(); });
}

void take_picture(Camera& camera, glass::LiquidPictureDialog& picture, const QString& name) {
    picture.show();
    picture.findChild<QPushButton*>(QStringLiteral("picture_start"))->click();
    for (int minutes = 0; minutes < 5 && picture.rendering(); ++minutes)
        wait_for([&] { return !picture.rendering() && picture.has_picture(); });
    pass_time();
    camera.save(picture.grab(), name);
    picture.hide();
}

/// The window as it is seen: grabbed alone it has not what is drawn over the liquid.
QPixmap with_marks(main::MainWindow& window, glass::GlassView& view) {
    QPixmap picture = window.grab();
    QPainter(&picture).drawImage(QRect(view.mapTo(&window, QPoint()), view.size()), view.picture());
    return picture;
}

}  // namespace

/// The glass while milk falls into it, and what a picture of that is like.
void take_tea(Camera& camera) {
    main::MainWindow& window = camera.window();
    main::TeaMode& tea = window.parts().tea;
    tea.enter();
    window.studio().commands().action(Command::TeaPour)->trigger();
    pass_time();
    wait_for_liquid(camera, tea, 0.9, QStringLiteral("milk-tea"));
    camera.save(window.grab(), QStringLiteral("milk-tea"));
    appearance::apply_theme(*qApp, appearance::Theme::Light);
    pass_time();
    wait_for([&] { return tea.page().view().finished(); });
    camera.save(window.grab(), QStringLiteral("milk-tea-light"));
    appearance::apply_theme(*qApp, appearance::Theme::Dark);
    take_picture(camera, tea.picture(), QStringLiteral("milk-tea-picture"));
    tea.leave();
    pass_time();
}

/// Liquid that meets a pillar and milk, and what a picture of that is like; then a ball in the wind.
void take_tank(Camera& camera) {
    main::MainWindow& window = camera.window();
    main::TankMode& tank = window.parts().tank;
    tank.open_scene(QStringLiteral("two-liquids"));
    pass_time();
    wait_for_liquid(camera, tank, 0.6, QStringLiteral("glass-tank"));
    camera.save(window.grab(), QStringLiteral("glass-tank"));
    take_picture(camera, tank.picture(), QStringLiteral("glass-tank-picture"));
    tank.open_scene(QStringLiteral("falling-liquid"));
    tank.session().wait_until_applied();
    pass_time();
    for (const Command command : {Command::TankWind, Command::TankWindLeft, Command::TankVelocity})
        window.studio().commands().action(command)->trigger();
    wait_for_liquid(camera, tank, 0.3, QStringLiteral("glass-tank-wind"));
    camera.save(with_marks(window, tank.page().view()), QStringLiteral("glass-tank-wind"));
    window.studio().commands().action(Command::TankVelocity)->trigger();
    tank.leave();
    pass_time();
}

}  // namespace pastoso::screens
