// The part of CanvasView that draws: brings what changed onto the graphics card and shades it.

#include "appearance/theme.hpp"
#include "core/error.hpp"
#include "shade/outline.hpp"
#include "view/canvas_shader.hpp"
#include "view/canvas_view.hpp"
#include "view/damaged_pixels.hpp"

#include <utility>

#include <QElapsedTimer>
#include <QPolygonF>
#include <glm/common.hpp>

namespace pastoso::view {
namespace {

/// A frame that has spent this much on what changed refines nothing more.
constexpr double kBusy_s = 0.010;

/// So much of a frame is spent on putting onto the graphics card what has changed.
constexpr double kUpload_s = 0.008;

/// A frame waits so long for what is being made.
constexpr std::chrono::microseconds kPatience(4000);

/// So many presentations are made ahead of the frames that show them.
constexpr std::size_t kMostMade = 2;

Rgb ground_colour() {
    const QColor& ground = appearance::colours().ground;
    return {static_cast<float>(ground.redF()), static_cast<float>(ground.greenF()),
            static_cast<float>(ground.blueF())};
}

/// The pixels of a window that were in it before, too: those of its edge are left out.
QRegion moved_window(const ViewTransform& from, const ViewTransform& to, const QRect& window) {
    QPolygonF corners;
    for (const QPoint& corner :
         {window.topLeft(), window.topRight() + QPoint(1, 0), window.bottomRight() + QPoint(1, 1),
          window.bottomLeft() + QPoint(0, 1)}) {
        const glm::dvec2 px = to.device_from_cell(from.cell_from_device({corner.x(), corner.y()}));
        corners << QPointF(px.x, px.y);
    }
    const QRegion all = QRegion(corners.toPolygon());
    return all & all.translated(2, 2) & all.translated(-2, -2) & all.translated(2, -2) &
           all.translated(-2, 2) & window;
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
    drop_textures();
}

/// They hold nothing of what is to be seen.
void CanvasView::drop_textures() {
    shown_.reset();
    asked_.reset();
    presentations_.clear();
    if (upload_.active()) upload_.end();
    outdated_ = presenter_.busy();
}

void CanvasView::paintGL() {
    if (!graphics_ready() || wanted_ == nullptr) return;
    const QSize size(static_cast<int>(window_px().x), static_cast<int>(window_px().y));
    if (size != picture_.size()) {
        picture_.resize(size, ground_colour());
        moved_from_.reset();
        damage_all();
    }
    // First: what is damaged afterwards is told as it lies now.
    const auto from = std::exchange(moved_from_, std::nullopt);
    if (from && shown_ != nullptr) move_picture(*from, QRect(QPoint(0, 0), size));
    upload_changes();
    // Another canvas takes the place of what was shown when all of it is there.
    if (shown_ == nullptr) return picture_.copy_to(defaultFramebufferObject());
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

/// What is there is moved along, where shading all of it anew would hold up the hand.
void CanvasView::move_picture(const ViewTransform& from, const QRect& window) {
    if (view_ == from) return;
    const glm::dvec2 by_px = view_.origin_px - from.origin_px;
    const bool pans = view_.zoom == from.zoom && view_.angle_deg == from.angle_deg &&
                      view_.mirrored == from.mirrored && by_px == glm::round(by_px);
    if (!pans && (plan_.has_damage() || plan_.is_quick(window, view_.zoom)))
        return plan_.add_damage(window);
    picture_.move(from, view_, ground_colour());
    if (pans)
        plan_.shift({static_cast<int>(by_px.x), static_cast<int>(by_px.y)}, window);
    else
        plan_.keep_as_draft(moved_window(from, view_, window), window);
}

Sight CanvasView::wanted_sight() const {
    return {wanted_, seen_tracing(), lighting_, viewing_, look_};
}

/// The latest is made while what was made before waits for the next frame: it is in that frame, too.
void CanvasView::ask_presenter() {
    if (wanted_ == nullptr || presenter_.busy() || presentations_.size() >= kMostMade) return;
    const Sight sight = wanted_sight();
    if (sight == asked_ || sight == refused_) return;
    presenter_.make(sight, !asked_);
    asked_ = sight;
}

void CanvasView::take_presentation(std::chrono::microseconds patience) {
    auto made = presenter_.take(patience);
    if (!made) return;
    if (!std::exchange(outdated_, false)) presentations_.push_back(std::move(*made));
    ask_presenter();
}

void CanvasView::upload_changes() {
    QElapsedTimer timer;
    timer.start();
    const auto left_s = [&] { return kUpload_s - 1e-9 * static_cast<double>(timer.nsecsElapsed()); };
    // Of a stroke little has changed, which is there at once and in this frame.
    if (presentations_.empty()) take_presentation(kPatience);
    QRegion cells;
    while (left_s() > 0.0 && (upload_.active() || begin_upload()))
        if (upload_.go_on(left_s(), textures_, cells)) finish_upload();
    if (shown_ != nullptr) plan_.add_damage(damaged_region(cells));
    if (upload_.active() || !presentations_.empty()) update();
    take_presentation({});
    ask_presenter();
    if (shown_ != nullptr && draws_outlines()) upload_outlines();
}

/// False when nothing has been made.
bool CanvasView::begin_upload() {
    if (presentations_.empty()) return false;
    Presentation made = std::move(presentations_.front());
    presentations_.pop_front();
    if (!made.fault.empty()) {
        drop_textures();
        refused_ = made.sight;
        throw core::InputError(made.fault);
    }
    if (made.begins && !prepare_textures()) return false;
    upload_.begin(std::move(made));
    return true;
}

void CanvasView::finish_upload() {
    const Presentation done = upload_.end();
    const bool relooked = done.begins || done.sight.look != drawn_.look;
    if (done.begins)
        outlines_.reset(done.seen->film.shape);
    else if (done.recoloured)
        outlines_.forget_all();
    else
        outlines_.forget(done.tiles);
    shown_ = done.sight.painting;
    seen_ = done.seen;
    drawn_ = done.sight;
    if (relooked) prepare_look();
    show_heights(done.look, relooked);
    if (relooked || done.recoloured) damage_all();
}

bool CanvasView::draws_outlines() const {
    return has_outlines(drawn_.look) && shade::outline_strength(view_.zoom) > 0.0F;
}

void CanvasView::upload_outlines() {
    textures_.upload_outlines(outlines_.update(*seen_, seen_cells(), drawn_.viewing.to_rgb, pool_));
}

QRegion CanvasView::outlined_region() const {
    QRegion region;
    if (!draws_outlines()) return region;
    // Half a cell farther is enough, where damage reaches two.
    for (const QRect& cells : outlines_.cells_near(seen_cells()))
        region += damaged_pixels(view_, cells.adjusted(1, 1, -1, -1));
    return region;
}

bool CanvasView::prepare_textures() {
    try {
        textures_.initialise(&gl(), wanted_->film.shape);
    } catch (const core::InputError& error) {
        fail(QString::fromUtf8(error.what()));
        return false;
    }
    return true;
}

/// Where the screen may change: the changed cells and those whose splines reach them.
QRegion CanvasView::damaged_region(const QRegion& cells) const {
    QRegion region;
    for (const QRect& part : cells)
        region += damaged_pixels(view_, part);
    return region;
}

double CanvasView::shade_job(const ShadingPlan::Job& job) {
    const Scene scene{
        &textures_,    shown_->film.cell_mm, view_,           lighting_,        drawn_.look,
        scale_top_mm_, drawn_.viewing.space, ground_colour(), outlined_region()};
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
