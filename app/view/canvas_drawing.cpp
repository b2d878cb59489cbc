// The part of CanvasView that draws: brings what changed onto the graphics card and shades it.

#include "appearance/theme.hpp"
#include "core/error.hpp"
#include "shade/outline.hpp"
#include "view/canvas_shader.hpp"
#include "view/canvas_view.hpp"
#include "view/damaged_pixels.hpp"

#include <utility>

#include <QElapsedTimer>

namespace pastoso::view {
namespace {

/// A frame that has spent this much on what changed refines nothing more.
constexpr double kBusy_s = 0.010;

QRect qt_rect(const grid::Rect& cells) {
    return {cells.x0, cells.y0, cells.width(), cells.height()};
}

Rgb ground_colour() {
    const QColor& ground = appearance::colours().ground;
    return {static_cast<float>(ground.redF()), static_cast<float>(ground.greenF()),
            static_cast<float>(ground.blueF())};
}

}  // namespace

void CanvasView::make_graphics() {
    picture_.initialise(&gl());
    overlay_.initialise(&gl());
}

void CanvasView::free_graphics() {
    textures_.release();
    picture_.release();
    overlay_.release();
    shown_.reset();
}

void CanvasView::paintGL() {
    if (!graphics_ready() || wanted_ == nullptr) return;
    const QSize size(static_cast<int>(window_px().x), static_cast<int>(window_px().y));
    if (size != picture_.size()) {
        picture_.resize(size);
        damage_all();
    }
    upload_changes();
    if (shown_ == nullptr) return;
    double spent_s = 0.0;
    if (plan_.has_damage())
        spent_s = shade_job(plan_.take_damage(QRect(QPoint(0, 0), size), view_.zoom));
    if (plan_.can_refine() && spent_s < kBusy_s) shade_job(plan_.take_refinement(view_.zoom));
    if (plan_.can_refine()) update();
    if (plan_.has_drafts() && !cooling_.isActive()) cooling_.start();
    picture_.copy_to(defaultFramebufferObject());
    if (surface_ == document::Surface::Canvas) draw_selection();
    interactions_.draw(overlay());
}

void CanvasView::upload_changes() {
    if (shown_ != wanted_ || retrace_) {
        if (shown_ == nullptr && !prepare_textures()) return;
        auto seen = tracing_ground_.below(wanted_, seen_tracing(), pool_);
        if (shown_ == nullptr) outlines_.reset(wanted_->film.shape);
        const LayerChanges changes = layers_.update(shown_ == nullptr ? nullptr : seen_.get(), *seen,
                                                    lighting_, pool_, viewing_.to_rgb);
        textures_.upload_surface(layers_, changes.surface);
        textures_.upload_colours(changes.colours);
        outlines_.forget(changes.tiles);
        shown_ = wanted_;
        seen_ = std::move(seen);
        retrace_ = false;
        if (!relook_) upload_look(changes.tiles);
        plan_.add_damage(damaged_region(changes));
    }
    if (relight_) upload_shadows();
    if (relook_) upload_new_look();
    if (recolour_) {
        textures_.upload_colours(CanvasLayers::recolour(*seen_, viewing_.to_rgb, pool_));
        outlines_.forget_all();
        recolour_ = false;
        damage_all();
    }
    if (draws_outlines()) upload_outlines();
}

bool CanvasView::draws_outlines() const {
    return has_outlines(look_) && shade::outline_strength(view_.zoom) > 0.0F;
}

void CanvasView::upload_outlines() {
    textures_.upload_outlines(outlines_.update(*seen_, seen_cells(), viewing_.to_rgb, pool_));
}

QRegion CanvasView::outlined_region() const {
    QRegion region;
    if (!draws_outlines()) return region;
    // Half a cell farther is enough, where damage reaches two.
    for (const QRect& cells : outlines_.cells_near(seen_cells()))
        region += damaged_pixels(view_, cells.adjusted(1, 1, -1, -1));
    return region;
}

void CanvasView::upload_shadows() {
    QElapsedTimer timer;
    timer.start();
    layers_.relight(*shown_, lighting_, pool_);
    textures_.upload_surface(layers_, qt_rect(layers_.cells_with_border()));
    shadows_took_s_ = 1e-9 * static_cast<double>(timer.nsecsElapsed());
    relight_ = false;
    damage_all();
}

bool CanvasView::prepare_textures() {
    try {
        textures_.initialise(&gl(), wanted_->film.shape);
    } catch (const core::InputError& error) {
        fail(QString::fromUtf8(error.what()));
        return false;
    }
    relight_ = false;
    recolour_ = false;
    relook_ = true;
    light_rests_.stop();
    shadows_took_s_ = 0.0;
    damage_all();
    return true;
}

/// Where the screen may change: the changed cells and those whose splines reach them.
QRegion CanvasView::damaged_region(const LayerChanges& changes) const {
    QRegion region;
    for (const QRect& cells : changes.surface)
        region += damaged_pixels(view_, cells);
    return region;
}

double CanvasView::shade_job(const ShadingPlan::Job& job) {
    const Scene scene{&textures_,    shown_->film.cell_mm, view_,           lighting_,        look_,
                      scale_top_mm_, viewing_.space,       ground_colour(), outlined_region()};
    double seconds = 0.0;
    for (const QRect& part : job.region)
        seconds += picture_.shade(part, job.quality, scene);
    plan_.measured(job, seconds);
    return seconds;
}

Overlay CanvasView::overlay() {
    return {overlay_,
            *this,
            {view_.device_from_cell({0.0, 0.0}), view_.zoom / shown_->film.cell_mm * view_.axes(),
             picture_.size()},
            px_mm()};
}

}  // namespace pastoso::view
