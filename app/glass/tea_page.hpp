// The glass of tea in place of the canvas.
#pragma once

#include "glass/glass_page.hpp"
#include "glass/tea_panel.hpp"
#include "glass/tea_view.hpp"

namespace pastoso::glass {

class TeaPage : public GlassPage {
    Q_OBJECT
  public:
    explicit TeaPage(const TeaActions& actions, QWidget* parent = nullptr);

    TeaView& view() override { return *view_; }
    TeaPanel& panel() { return *panel_; }

    void show_status(const session::TeaStatus& status);

  private:
    TeaPage(TeaView* view, TeaPanel* panel, const TeaActions& actions, QWidget* parent);

    TeaView* view_;
    TeaPanel* panel_;
};

}  // namespace pastoso::glass
