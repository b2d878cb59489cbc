#include "appearance/theme.hpp"
#include "main/tea_mode.hpp"
#include "states.hpp"
#include "tea/tea_page.hpp"
#include "tea/tea_picture_dialog.hpp"

#include <QAction>
#include <QApplication>
#include <QPushButton>

namespace pastoso::screens {
namespace {

using commands::Command;

void wait_for_glass(Camera& camera, double until_s) {
    main::TeaMode& tea = camera.window().tea();
    tea.session().set_paused(false);
    tea.session().set_full_speed(true);
    // A second of the tea takes a few on a small machine.
    for (double second = 1.0; second <= until_s; second += 1.0)
        if (!wait_for([&] { return tea.session().status().last_s >= second; }))
            return camera.complain(QStringLiteral("milk-tea"));
    tea.session().set_paused(true);
    tea.session().wait_until_applied();
    pass_time();
    wait_for([&] { return tea.page().view().finished(); });
}

}  // namespace

/// As the glass stands after nine seconds, and what a picture of it is like.
void take_tea(Camera& camera) {
    main::MainWindow& window = camera.window();
    main::TeaMode& tea = window.tea();
    tea.enter();
    pass_time();
    wait_for_glass(camera, 9.0);
    camera.save(window.grab(), QStringLiteral("milk-tea"));
    appearance::apply_theme(*qApp, appearance::Theme::Light);
    pass_time();
    wait_for([&] { return tea.page().view().finished(); });
    camera.save(window.grab(), QStringLiteral("milk-tea-light"));
    appearance::apply_theme(*qApp, appearance::Theme::Dark);
    tea::TeaPictureDialog& picture = tea.picture();
    picture.show();
    picture.findChild<QPushButton*>(QStringLiteral("picture_start"))->click();
    for (int minutes = 0; minutes < 5 && picture.rendering(); ++minutes)
        wait_for([&] { return !picture.rendering() && picture.has_picture(); });
    pass_time();
    camera.save(picture.grab(), QStringLiteral("milk-tea-picture"));
    picture.hide();
    tea.leave();
    pass_time();
}

}  // namespace pastoso::screens
