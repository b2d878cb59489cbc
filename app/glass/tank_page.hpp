// The tank in place of the canvas.
#pragma once

#include "glass/glass_page.hpp"
#include "glass/tank_panel.hpp"
#include "glass/tank_view.hpp"

namespace pastoso::glass {

class TankPage : public GlassPage {
    Q_OBJECT
  public:
    explicit TankPage(const TankActions& actions, QWidget* parent = nullptr);

    TankView& view() override { return *view_; }
    TankPanel& panel() { return *panel_; }

    void show_status(const session::TankStatus& status);

  private:
    TankPage(TankView* view, TankPanel* panel, const TankActions& actions, QWidget* parent);

    TankView* view_;
    TankPanel* panel_;
};

}  // namespace pastoso::glass
