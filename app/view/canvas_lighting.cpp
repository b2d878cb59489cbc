// The part of CanvasView that shows in what light, and how, the paint is looked at.

#include "view/canvas_view.hpp"
#include "view/look_legend.hpp"

namespace pastoso::view {
namespace {

constexpr double kLegendMargin_px = 12.0;

}  // namespace

void CanvasView::set_look(screen::Look look) {
    if (look == look_) return;
    look_ = look;
    legend_->show_look(look_, scale_top_mm_);
    place_legend();
    screen_->refresh();
}

void CanvasView::set_lighting(const shade::Lighting& lighting) {
    const bool changed = !(lighting == lighting_);
    lighting_ = lighting;
    screen_->damage_all();
    if (changed) Q_EMIT lighting_changed();
}

void CanvasView::scale_shown(double top_mm) {
    scale_top_mm_ = top_mm;
    legend_->show_look(look_, scale_top_mm_);
}

void CanvasView::place_legend() {
    legend_->move(static_cast<int>(kLegendMargin_px),
                  height() - legend_->height() - static_cast<int>(kLegendMargin_px));
}

}  // namespace pastoso::view
