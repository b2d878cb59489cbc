#include "screen/gl_screen.hpp"

#include "appearance/shown_message.hpp"
#include "core/error.hpp"
#include "graphics/graphics_fault.hpp"
#include "screen/canvas_shader.hpp"
#include "screen/damaged_pixels.hpp"
#include "screen/qt_rect.hpp"
#include "screen/squint.hpp"
#include "screen/window_pixels.hpp"
#include "shade/outline.hpp"

#include <algorithm>
#include <utility>

#include <QElapsedTimer>
#include <QPolygonF>
#include <glm/common.hpp>

namespace pastoso::screen {
namespace {

/// Drafts left alone for about this long are refined: longer than the pause between two movements of a
/// hand.
constexpr int kCoolingTime_ms = 60;

/// A frame that costs this much for what changed refines nothing more.
constexpr double kBusy_s = 0.010;

/// So much of a frame is spent on putting onto the graphics card what has changed.
constexpr double kUpload_s = 0.008;

/// A frame waits so long for what is being made.
constexpr std::chrono::microseconds kPatience(4000);

/// So many presentations are made ahead of the frames that show them.
constexpr std::size_t kMostMade = 2;

/// The pixels of a window that were in it before, too: those of its edge are left out.
QRegion moved_window(const ViewTransform& from, const ViewTransform& to, const QRect& window) {
    QPolygonF corners;
    for (const QPoint& corner :
         {window.topLeft(), window.topRight() + QPoint(1, 0), window.bottomRight() + QPoint(1, 1),
          window.bottomLeft() + QPoint(0, 1)}) {
        const glm::dvec2 px = moved_px(from, to, {corner.x(), corner.y()});
        corners << QPointF(px.x, px.y);
    }
    const QRegion all = QRegion(corners.toPolygon());
    return all & all.translated(2, 2) & all.translated(-2, -2) & all.translated(2, -2) &
           all.translated(-2, 2) & window;
}

bool holds(const grid::Rect& all, const grid::Rect& part) {
    return part.empty() || grid::intersection(all, part) == part;
}

}  // namespace

GlScreen::GlScreen(ScreenHost& host, QWidget& parent)
    : GraphicsWidget(&parent), host_(host), presenter_([this] {
          QMetaObject::invokeMethod(
              this, [this] { update(); }, Qt::QueuedConnection);
      }) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    cooling_.setSingleShot(true);
    cooling_.setInterval(kCoolingTime_ms);
    connect(&cooling_, &QTimer::timeout, this, [this] {
        plan_.let_drafts_cool();
        if (plan_.has_drafts()) cooling_.start();
        if (plan_.can_refine()) update();
    });
    connect(this, &GraphicsWidget::failed, this,
            [this](const QString& sentence) { host_.screen_failed(sentence); });
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            [this] { update(); });
    connect(this, &QOpenGLWidget::frameSwapped, this, [this] { host_.frame_shown(); });
}

GlScreen::~GlScreen() {
    release_graphics();
}

void GlScreen::refresh() {
    ask_presenter();
    update();
}

void GlScreen::begin_other_canvas() {
    drop_textures();
    damage_all();
}

void GlScreen::damage_all() {
    plan_.add_damage(QRect(QPoint(0, 0), window_px()));
    update();
}

bool GlScreen::finished() const {
    const Sight wanted = host_.sight();
    const bool shows = shown_ != nullptr ? drawn_ == wanted : wanted.painting == nullptr;
    const bool outlined = shown_ == nullptr || holds(outlined_, cells_to_outline(drawn_));
    return shows && outlined && (shown_ == nullptr || drawn_from_ == host_.view_transform()) &&
           !presenter_.busy() && presentations_.empty() && !upload_.active() && !plan_.has_damage() &&
           !plan_.has_drafts();
}

QSize GlScreen::window_px() const {
    return screen::window_px(*this);
}

void GlScreen::make_graphics() {
    picture_.initialise(&gl());
    overlay_.initialise(&gl(), *this);
}

void GlScreen::free_graphics() {
    textures_.release();
    picture_.release();
    timer_.release();
    overlay_.release();
    drop_textures();
}

/// They hold nothing of what is to be seen.
void GlScreen::drop_textures() {
    shown_.reset();
    asked_.reset();
    presentations_.clear();
    if (upload_.active()) upload_.end();
    outdated_ = presenter_.busy();
}

void GlScreen::paintGL() {
    if (!graphics_ready() || host_.sight().painting == nullptr) return;
    try {
        draw_frame();
        graphics::expect_no_error(gl());
    } catch (const graphics::GraphicsFault& fault) {
        fail(appearance::shown_message(fault.message()));
    }
}

/// A context that was lost, and for which there is no other.
void GlScreen::paintEvent(QPaintEvent* event) {
    if (!isValid()) return fail(tr("There is no OpenGL any more to draw the canvas with."));
    GraphicsWidget::paintEvent(event);
}

void GlScreen::draw_frame() {
    const QSize size = window_px();
    const QRect window(QPoint(0, 0), size);
    if (size != picture_.size()) {
        picture_.resize(size, ground_colour());
        drawn_from_.reset();
        damage_all();
    }
    // First: what is damaged afterwards is told as it lies now.
    const ViewTransform view = host_.view_transform();
    const auto from = std::exchange(drawn_from_, view);
    if (from && shown_ != nullptr) move_picture(*from, window);
    upload_changes();
    // Another canvas takes the place of what was shown when all of it is there.
    if (shown_ == nullptr) return finish_picture();
    for (const ShadingTimer::Measured& job : timer_.take_measured())
        plan_.measured(job.samples, job.seconds);
    double expected_s = 0.0;
    if (plan_.has_damage()) {
        const ShadingPlan::Job job = plan_.take_damage(window, view.zoom);
        expected_s = plan_.expected_s(job);
        shade_job(job);
    }
    if (plan_.can_refine() && expected_s < kBusy_s) shade_job(plan_.take_refinement(view.zoom));
    if (plan_.can_refine()) update();
    if (plan_.has_drafts() && !cooling_.isActive()) cooling_.start();
    finish_picture();
    host_.draw_over(*shown_, overlay_);
}

void GlScreen::finish_picture() {
    picture_.finish(appearance::screen_colours().of_painting(), squint_px(*this),
                    defaultFramebufferObject());
}

/// What is there is moved along, where shading all of it anew would hold up the hand.
void GlScreen::move_picture(const ViewTransform& from, const QRect& window) {
    const ViewTransform& view = host_.view_transform();
    if (view == from) return;
    const std::optional<glm::ivec2> pans = whole_pixels_between(from, view);
    if (!pans && (plan_.has_damage() || plan_.is_quick(window, view.zoom)))
        return plan_.add_damage(window);
    picture_.move(from, view, ground_colour());
    if (pans)
        plan_.shift({pans->x, pans->y}, window);
    else
        plan_.keep_as_draft(moved_window(from, view, window), window);
}

/// The latest is made while what was made before waits for the next frame: it is in that frame, too.
void GlScreen::ask_presenter() {
    if (presenter_.busy() || presentations_.size() >= kMostMade) return;
    const Sight sight = host_.sight();
    if (sight.painting == nullptr || sight == refused_) return;
    const grid::Rect outlined = cells_to_outline(sight);
    if (sight == asked_ && holds(asked_outlined_, outlined)) return;
    presenter_.make(sight, !asked_, outlined);
    asked_ = sight;
    asked_outlined_ = outlined;
}

void GlScreen::take_presentation(std::chrono::microseconds patience) {
    auto made = presenter_.take(patience);
    if (!made) return;
    if (!std::exchange(outdated_, false)) presentations_.push_back(std::move(*made));
    ask_presenter();
}

void GlScreen::upload_changes() {
    QElapsedTimer timer;
    timer.start();
    const auto left_s = [&] { return kUpload_s - 1e-9 * static_cast<double>(timer.nsecsElapsed()); };
    // Of a stroke little has changed, which is there at once and in this frame.
    if (presentations_.empty()) take_presentation(kPatience);
    QRegion cells;
    while (left_s() > 0.0 && (upload_.active() || begin_upload()))
        if (upload_.go_on(left_s(), textures_, cells)) finish_upload(cells);
    if (shown_ != nullptr) plan_.add_damage(damaged_pixels(host_.view_transform(), cells));
    if (upload_.active() || !presentations_.empty()) update();
    take_presentation({});
    ask_presenter();
}

/// False when nothing has been made.
bool GlScreen::begin_upload() {
    if (presentations_.empty()) return false;
    Presentation made = std::move(presentations_.front());
    presentations_.pop_front();
    if (!made.fault.empty()) {
        drop_textures();
        refused_ = made.sight;
        throw core::InputError(made.fault);
    }
    if (made.begins) textures_.initialise(&gl(), made.seen->film.shape);
    upload_.begin(std::move(made));
    return true;
}

/// What was shaded before they were known is shaded again.
void GlScreen::note_outlines(const Presentation& done, QRegion& changed) {
    if (done.begins || done.recoloured)
        outlines_.reset(done.seen->film.shape);
    else
        outlines_.forget(done.tiles);
    for (const OutlinePatch& patch : done.outlines) {
        outlines_.note(patch);
        changed += qt_rect(patch.cells);
    }
    outlined_ = done.outlined;
}

/// Adds to the cells whose picture is another.
void GlScreen::finish_upload(QRegion& changed) {
    const Presentation done = upload_.end();
    const bool relooked = done.begins || done.sight.look != drawn_.look;
    note_outlines(done, changed);
    shown_ = done.sight.painting;
    seen_ = done.seen;
    drawn_ = done.sight;
    if (relooked) picture_.prepare(drawn_.look);
    show_heights(done.look, relooked);
    if (relooked || done.recoloured) damage_all();
}

/// Those in the window, where it draws outlines.
grid::Rect GlScreen::cells_to_outline(const Sight& sight) const {
    const ViewTransform& view = host_.view_transform();
    if (!has_outlines(sight.look) || shade::outline_strength(view.zoom) == 0.0F) return {};
    return seen_cells(view, window_px(), sight.painting->film.shape);
}

QRegion GlScreen::outlined_region() const {
    QRegion region;
    // Half a cell farther is enough, where damage reaches two.
    for (const QRect& cells : outlines_.cells_near(cells_to_outline(drawn_)))
        region += damaged_pixels(host_.view_transform(), cells.adjusted(1, 1, -1, -1));
    return region;
}

/// The scale of colours reaches as high as the paint has been since this look began.
void GlScreen::show_heights(const std::vector<LookPatch>& patches, bool begins) {
    if (drawn_.look != Look::Height) return;
    highest_mm_ = std::max(begins ? 0.0 : highest_mm_, highest_mm(patches));
    if (scale_top_mm(highest_mm_) == scale_top_mm_) return;
    scale_top_mm_ = scale_top_mm(highest_mm_);
    host_.scale_shown(scale_top_mm_);
    damage_all();
}

void GlScreen::shade_job(const ShadingPlan::Job& job) {
    const Scene scene{
        &textures_,    shown_->film.cell_mm, host_.view_transform(), host_.sight().lighting, drawn_.look,
        scale_top_mm_, drawn_.viewing.space, ground_colour(),        outlined_region()};
    timer_.begin();
    for (const QRect& part : job.region)
        picture_.shade(part, job.quality, scene);
    timer_.end(job.samples());
}

}  // namespace pastoso::screen
