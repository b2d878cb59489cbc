#include "glass/tank_page.hpp"

#include "appearance/shown_number.hpp"

namespace pastoso::glass {

TankPage::TankPage(const TankActions& actions, QWidget* parent)
    : TankPage(new TankView, new TankPanel(actions), actions, parent) {}

TankPage::TankPage(TankView* view, TankPanel* panel, const TankActions& actions, QWidget* parent)
    : GlassPage(view, panel, actions.glass,
                {QStringLiteral("tank"), tr("Moment of the tank"),
                 tr("Drag to any moment of the tank; going on goes on from its last"),
                 tr("Liquid in the tank, and how many steps a second are computed"),
                 tr("Filling the tank...")},
                parent),
      view_(view),
      panel_(panel) {}

void TankPage::show_status(const session::TankStatus& status) {
    show_time(status, tr("%1 l").arg(appearance::shown_number(1e3 * status.volume_m3, 2)), 2);
}

}  // namespace pastoso::glass
