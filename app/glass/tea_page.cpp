#include "glass/tea_page.hpp"

#include "appearance/shown_number.hpp"

namespace pastoso::glass {

TeaPage::TeaPage(const TeaActions& actions, QWidget* parent)
    : TeaPage(new TeaView, new TeaPanel(actions), actions, parent) {}

TeaPage::TeaPage(TeaView* view, TeaPanel* panel, const TeaActions& actions, QWidget* parent)
    : GlassPage(view, panel, actions.glass,
                {QStringLiteral("tea"), tr("Moment of the tea"),
                 tr("Drag to any moment of the glass; going on goes on from its last"),
                 tr("Milk poured so far, and how many steps of 1/30 s a second are computed"),
                 tr("Filling the glass...")},
                parent),
      view_(view),
      panel_(panel) {}

void TeaPage::show_status(const session::TeaStatus& status) {
    QString hint;
    if (status.at_rest) hint = tr("Press on the tea to pour milk where you point");
    if (status.full && status.pouring) hint = tr("The glass is full");
    show_time(status, tr("%1 ml of milk").arg(appearance::shown_number(1e6 * status.milk_m3, 1)), 1,
              hint);
}

}  // namespace pastoso::glass
