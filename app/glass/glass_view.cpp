#include "glass/glass_view.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QPainterPath>
#include <QTabletEvent>
#include <QWheelEvent>

namespace pastoso::glass {
namespace {

/// What a frame may take while something moves, and while a picture at rest gets finer.
constexpr double kDraft_s = 0.035, kRefinement_s = 0.045;
constexpr int kCoarsest = 2;  ///< device pixels a side of a pixel of a draft
constexpr int kPasses = 8;    ///< of a picture at rest
constexpr int kHurriedPasses = 3;
constexpr int kRest_ms = 140;
constexpr double kOrbit_deg_per_px = 0.35;

std::unique_ptr<QOpenGLFramebufferObject> new_picture(QSize size, GLenum format) {
    return std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::NoAttachment,
                                                      GL_TEXTURE_2D, format);
}

/// The row that is first in one is last in the other.
void copy_turned(QOpenGLExtraFunctions& gl, GLuint from, const QRect& part, GLuint to,
                 const QRect& place) {
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    gl.glBlitFramebuffer(part.x(), part.y(), part.x() + part.width(), part.y() + part.height(),
                         place.x(), place.y() + place.height(), place.x() + place.width(), place.y(),
                         GL_COLOR_BUFFER_BIT, part.size() == place.size() ? GL_NEAREST : GL_LINEAR);
}

}  // namespace

GlassView::GlassView(QWidget* parent) : GraphicsWidget(parent), passes_(kPasses) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setMinimumSize(320, 240);
    resting_.setSingleShot(true);
    resting_.setInterval(kRest_ms);
    connect(&resting_, &QTimer::timeout, this, [this] { update(); });
}

void GlassView::set_camera(const GlassCamera& camera) {
    if (camera == camera_) return;
    camera_ = camera;
    begin_anew();
    Q_EMIT camera_changed();
}

bool GlassView::finished() const {
    return graphics_ready() && shows_latest_ && !draft_is_due_ && pass_ >= passes_;
}

QImage GlassView::picture() {
    const auto pointer = std::exchange(pointer_, std::nullopt);
    for_screen_ = false;
    QImage picture = grabFramebuffer();
    for_screen_ = true;
    pointer_ = pointer;
    update();
    return picture;
}

void GlassView::set_hurried(bool hurried) {
    resting_.setInterval(hurried ? 0 : kRest_ms);
    passes_ = hurried ? kHurriedPasses : kPasses;
    update();
}

void GlassView::take_moment() {
    has_moment_ = true;
    shows_latest_ = false;
    begin_anew();
}

/// Something else is to be seen.
void GlassView::begin_anew() {
    draft_is_due_ = true;
    pass_ = row_ = 0;
    resting_.start();
    update();
}

QSize GlassView::device_size() const {
    const double ratio = devicePixelRatioF();
    return {static_cast<int>(std::lround(width() * ratio)),
            static_cast<int>(std::lround(height() * ratio))};
}

// ---- drawing

void GlassView::make_graphics() {
    renderer().initialise(&gl());
    finish_.initialise(&gl());
    begin_anew();
}

void GlassView::free_graphics() {
    renderer().release();
    finish_.release();
    shows_latest_ = false;
    draft_.reset();
    still_.reset();
    seen_.reset();
}

/// A draft at once, as coarse as it must be; once nothing moves, strips of the picture in full quality
/// follow, one for each frame.
void GlassView::paintGL() {
    if (!graphics_ready()) return;
    if (!has_moment_) return QPainter(this).fillRect(rect(), palette().window());
    const QSize size = device_size();
    if (!shows_latest_) show_latest();
    shows_latest_ = true;
    if (still_ == nullptr || still_->size() != size) {
        still_ = new_picture(size, GL_RGBA16F);
        seen_ = new_picture(size, GL_RGBA16);
        draft_is_due_ = true;
        pass_ = row_ = 0;
    }
    if (draft_is_due_)
        draw_draft(size);
    else if (pass_ < passes_ && !resting_.isActive())
        refine(size);
    compose(size);
    present(size);
    put_marks_over(size);
    if (pass_ < passes_ && !resting_.isActive()) update();
}

void GlassView::draw_draft(QSize size) {
    const double pixels = static_cast<double>(size.width()) * size.height();
    const double coarse = std::sqrt(pixels * pixel_cost_s_ / kDraft_s);
    const int side = std::clamp(static_cast<int>(std::ceil(coarse)), 1, kCoarsest);
    const QSize draft((size.width() + side - 1) / side, (size.height() + side - 1) / side);
    if (draft_ == nullptr || draft_->size() != draft) draft_ = new_picture(draft, GL_RGBA16F);
    QElapsedTimer timer;
    timer.start();
    renderer().draw(*draft_, QRect(QPoint(0, 0), draft), camera_, 0, Quality::Draft);
    gl().glFinish();
    const double cost_s =
        1e-9 * static_cast<double>(timer.nsecsElapsed()) / (draft.width() * draft.height());
    constexpr double kNewestShare = 0.3;
    pixel_cost_s_ += kNewestShare * (cost_s - pixel_cost_s_);
    draft_is_due_ = false;
}

void GlassView::refine(QSize size) {
    const double row_cost_s = std::max(pixel_cost_s_ * size.width(), 1e-9);
    const int rows = static_cast<int>(std::clamp(kRefinement_s / row_cost_s, 8.0, 1e5));
    const int end = std::min(row_ + rows, size.height());
    // From above, as pictures are read; OpenGL counts from below.
    renderer().draw(*still_, QRect(0, size.height() - end, size.width(), end - row_), camera_, pass_,
                    Quality::Full);
    gl().glFinish();
    row_ = end;
    if (row_ < size.height()) return;
    row_ = 0;
    if (++pass_ == passes_) Q_EMIT picture_finished();
}

void GlassView::compose(QSize size) {
    const int ready = pass_ > 0 ? size.height() : row_;
    if (ready < size.height())
        copy_turned(gl(), draft_->handle(), QRect(QPoint(0, 0), draft_->size()), seen_->handle(),
                    QRect(QPoint(0, 0), size));
    if (ready > 0)
        copy_turned(gl(), still_->handle(), QRect(0, size.height() - ready, size.width(), ready),
                    seen_->handle(), QRect(0, 0, size.width(), ready));
}

void GlassView::present(QSize size) {
    const GLuint frame = defaultFramebufferObject();
    if (for_screen_)
        return finish_.draw(seen_->texture(), size, appearance::screen_colours().of_painting(), frame);
    const QRect all(QPoint(0, 0), size);
    copy_turned(gl(), seen_->handle(), all, frame, all);
    gl().glBindFramebuffer(GL_FRAMEBUFFER, frame);
}

/// Into the frame, not onto the widget: where a picture of the window is taken, a painter of the widget
/// would draw into that picture, which the frame then covers.
void GlassView::put_marks_over(QSize size) {
    QOpenGLPaintDevice frame(size);
    frame.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&frame);
    painter.setRenderHint(QPainter::Antialiasing);
    draw_marks(painter, does_ == Does::Nothing ? pointer_ : std::nullopt);
}

QPainterPath GlassView::seen_ring(const glm::vec3& middle_m, double radius_m, double from_rad,
                                  double to_rad) const {
    constexpr int kCorners = 48;
    QPainterPath path;
    for (int i = 0; i <= kCorners; ++i) {
        const double angle = std::lerp(from_rad, to_rad, static_cast<double>(i) / kCorners);
        const glm::dvec2 way_m = radius_m * glm::dvec2(std::cos(angle), std::sin(angle));
        const QPointF at = seen(middle_m + glm::vec3(way_m, 0.0F));
        i == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    return path;
}

// ---- the hand

void GlassView::press(const QPointF& place, Qt::MouseButton button) {
    if (does_ != Does::Nothing) return;
    last_place_ = place;
    if (button == Qt::LeftButton && is_over_liquid(place)) {
        does_ = Does::Pour;
        press_liquid(place);
    } else {
        does_ = Does::Orbit;
        setCursor(Qt::ClosedHandCursor);
    }
    update();
}

void GlassView::drag(const QPointF& place) {
    if (does_ == Does::Pour) {
        drag_liquid(place);
    } else if (does_ == Does::Orbit) {
        const QPointF way = place - last_place_;
        GlassCamera camera = camera_;
        camera.orbit(-kOrbit_deg_per_px * way.x(), kOrbit_deg_per_px * way.y());
        set_camera(camera);
    }
    last_place_ = place;
}

void GlassView::lift() {
    if (std::exchange(does_, Does::Nothing) == Does::Pour) lift_from_liquid();
    set_cursor(last_place_);
    update();
}

void GlassView::set_cursor(const QPointF& place) {
    if (does_ == Does::Nothing) setCursor(is_over_liquid(place) ? Qt::CrossCursor : Qt::OpenHandCursor);
}

void GlassView::mousePressEvent(QMouseEvent* event) {
    press(event->position(), event->button());
}

void GlassView::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    drag(event->position());
    set_cursor(event->position());
    if (does_ == Does::Nothing) update();
}

void GlassView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) lift();
}

void GlassView::wheelEvent(QWheelEvent* event) {
    constexpr double kStep = 1.12, kNotch = 120.0;
    GlassCamera camera = camera_;
    camera.zoom(std::pow(kStep, event->angleDelta().y() / kNotch));
    set_camera(camera);
    event->accept();
}

/// A pen is a mouse that presses with its tip, and orbits with its lower button.
void GlassView::tabletEvent(QTabletEvent* event) {
    event->accept();
    pointer_ = event->position();
    switch (event->type()) {
        case QEvent::TabletPress:
            press(event->position(), event->button());
            break;
        case QEvent::TabletRelease:
            if (event->buttons() == Qt::NoButton) lift();
            break;
        default:
            drag(event->position());
            set_cursor(event->position());
            if (does_ == Does::Nothing) update();
    }
}

/// The right button turns the glass.
void GlassView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
}

void GlassView::leaveEvent(QEvent* event) {
    pointer_.reset();
    update();
    QOpenGLWidget::leaveEvent(event);
}

void GlassView::hideEvent(QHideEvent* event) {
    lift();
    QOpenGLWidget::hideEvent(event);
}

void stroke_mark(QPainter& painter, const QPainterPath& path, double opacity) {
    painter.setOpacity(opacity);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 110), 3.2, Qt::SolidLine, Qt::RoundCap));
    painter.strokePath(path, QPen(QColor(255, 255, 255, 230), 1.4, Qt::SolidLine, Qt::RoundCap));
    painter.setOpacity(1.0);
}

}  // namespace pastoso::glass
