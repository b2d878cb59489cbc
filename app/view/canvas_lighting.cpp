// The part of CanvasView that shows in what light, and how, the paint is looked at.

#include "core/error.hpp"
#include "view/canvas_view.hpp"
#include "view/look_legend.hpp"

#include <algorithm>

namespace pastoso::view {
namespace {

constexpr double kLegendMargin_px = 12.0;

}  // namespace

void CanvasView::set_look(Look look) {
    if (look == look_) return;
    look_ = look;
    legend_->show_look(look_, scale_top_mm_);
    place_legend();
    update();
}

void CanvasView::set_lighting(const shade::Lighting& lighting) {
    const bool changed = !(lighting == lighting_);
    lighting_ = lighting;
    damage_all();
    if (changed) Q_EMIT lighting_changed();
}

/// A driver that shades lit paint refuses none of the simpler looks; if it does, painting goes on.
void CanvasView::prepare_look() {
    try {
        picture_.prepare(drawn_.look);
    } catch (const core::InputError&) {
        look_ = drawn_.look = Look::Lit;
        legend_->show_look(look_, scale_top_mm_);
    }
}

/// The scale of colours reaches as high as the paint has been since this look began.
void CanvasView::show_heights(const std::vector<LookPatch>& patches, bool begins) {
    if (drawn_.look != Look::Height) return;
    highest_mm_ = std::max(begins ? 0.0 : highest_mm_, highest_mm(patches));
    if (scale_top_mm(highest_mm_) == scale_top_mm_) return;
    scale_top_mm_ = scale_top_mm(highest_mm_);
    legend_->show_look(look_, scale_top_mm_);
    damage_all();
}

void CanvasView::place_legend() {
    legend_->move(static_cast<int>(kLegendMargin_px),
                  height() - legend_->height() - static_cast<int>(kLegendMargin_px));
}

}  // namespace pastoso::view
