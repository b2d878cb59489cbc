// The part of CanvasView that shows in what light, and how, the paint is looked at.

#include "core/error.hpp"
#include "view/canvas_view.hpp"
#include "view/look_legend.hpp"

#include <algorithm>
#include <numeric>

namespace pastoso::view {
namespace {

constexpr double kLegendMargin_px = 12.0;

/// Shadows that take longer wait until the light rests.
constexpr double kQuickShadows_s = 0.012;

}  // namespace

void CanvasView::set_look(Look look) {
    if (look == look_) return;
    look_ = look;
    relook_ = true;
    legend_->show_look(look_, scale_top_mm_);
    place_legend();
    damage_all();
}

void CanvasView::set_lighting(const shade::Lighting& lighting) {
    const bool moved = lighting.azimuth_deg != lighting_.azimuth_deg ||
                       lighting.elevation_deg != lighting_.elevation_deg;
    const bool changed = !(lighting == lighting_);
    lighting_ = lighting;
    damage_all();
    if (changed) Q_EMIT lighting_changed();
    if (!moved) return;  // the shadows stay where they are
    if (shadows_took_s_ > kQuickShadows_s)
        light_rests_.start();
    else
        relight_ = true;
}

/// `tiles` have changed; all of them where another look is asked for.
void CanvasView::upload_look(const std::vector<int>& tiles) {
    if (!needs_thickness(look_)) return;
    const auto patches = look_patches(*seen_, look_, tiles, pool_);
    textures_.upload_look(patches);
    if (look_ != Look::Height) return;
    highest_mm_ = std::max(relook_ ? 0.0 : highest_mm_, highest_mm(patches));
    if (scale_top_mm(highest_mm_) == scale_top_mm_) return;
    scale_top_mm_ = scale_top_mm(highest_mm_);
    legend_->show_look(look_, scale_top_mm_);
    damage_all();
}

void CanvasView::upload_new_look() {
    try {
        picture_.prepare(look_);
    } catch (const core::InputError&) {
        // A driver that shades lit paint refuses none of the simpler looks; if it does, painting goes
        // on.
        look_ = Look::Lit;
        legend_->show_look(look_, scale_top_mm_);
    }
    std::vector<int> all(static_cast<std::size_t>(seen_->film.shape.tile_count()));
    std::iota(all.begin(), all.end(), 0);
    upload_look(all);
    relook_ = false;
}

void CanvasView::place_legend() {
    legend_->move(static_cast<int>(kLegendMargin_px),
                  height() - legend_->height() - static_cast<int>(kLegendMargin_px));
}

}  // namespace pastoso::view
