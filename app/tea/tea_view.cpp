#include "tea/tea_view.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTabletEvent>
#include <QWheelEvent>

namespace pastoso::tea {
namespace {

/// What a frame may take while something moves, and while a picture at rest gets finer.
constexpr double kDraft_s = 0.035, kRefinement_s = 0.045;
constexpr int kCoarsest = 3;  ///< device pixels a side of a pixel of a draft
constexpr int kPasses = 8;    ///< of a picture at rest
constexpr int kRest_ms = 140;
constexpr double kOrbit_deg_per_px = 0.35;

QOpenGLFramebufferObjectFormat fine_format() {
    QOpenGLFramebufferObjectFormat format;
    format.setInternalTextureFormat(GL_RGBA16F);
    return format;
}

}  // namespace

TeaView::TeaView(QWidget* parent) : GraphicsWidget(parent) {
    setObjectName(QStringLiteral("tea_view"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setMinimumSize(320, 240);
    resting_.setSingleShot(true);
    resting_.setInterval(kRest_ms);
    connect(&resting_, &QTimer::timeout, this, [this] { update(); });
}

TeaView::~TeaView() {
    release_graphics();
}

void TeaView::show_moment(std::shared_ptr<const session::TeaMoment> moment) {
    if (moment == wanted_) return;
    wanted_ = std::move(moment);
    begin_anew();
}

void TeaView::show_force(const session::TeaForce& force) {
    if (force == force_) return;
    force_ = force;
    update();
}

void TeaView::set_camera(const TeaCamera& camera) {
    if (camera == camera_) return;
    camera_ = camera;
    begin_anew();
    Q_EMIT camera_changed();
}

void TeaView::look_from_front() {
    set_camera(wanted_ != nullptr ? TeaCamera(wanted_->settings.cup) : TeaCamera());
}

bool TeaView::finished() const {
    return graphics_ready() && shown_ == wanted_ && !draft_is_due_ && pass_ == kPasses;
}

void TeaView::begin_anew() {
    draft_is_due_ = true;
    pass_ = row_ = 0;
    resting_.start();
    update();
}

QSize TeaView::device_size() const {
    const double ratio = devicePixelRatioF();
    return {static_cast<int>(std::lround(width() * ratio)),
            static_cast<int>(std::lround(height() * ratio))};
}

// ---- drawing

void TeaView::make_graphics() {
    renderer_.initialise(&gl());
    begin_anew();
}

void TeaView::free_graphics() {
    renderer_.release();
    draft_.reset();
    still_.reset();
    shown_.reset();
}

/// A draft at once, as coarse as it must be; once nothing moves, strips of the picture in full quality
/// follow, one for each frame.
void TeaView::paintGL() {
    if (!graphics_ready() || wanted_ == nullptr) return;
    const QSize size = device_size();
    if (shown_ != wanted_) {
        renderer_.show(*wanted_);
        shown_ = wanted_;
    }
    if (still_ == nullptr || still_->size() != size) {
        still_ = std::make_unique<QOpenGLFramebufferObject>(size, fine_format());
        draft_is_due_ = true;
        pass_ = row_ = 0;
    }
    if (draft_is_due_)
        draw_draft(size);
    else if (pass_ < kPasses && !resting_.isActive())
        refine(size);
    present(size);
    draw_marks();
    if (pass_ < kPasses && !resting_.isActive()) update();
}

void TeaView::draw_draft(QSize size) {
    const double pixels = static_cast<double>(size.width()) * size.height();
    const double coarse = std::sqrt(pixels * pixel_cost_s_ / kDraft_s);
    const int side = std::clamp(static_cast<int>(std::ceil(coarse)), 1, kCoarsest);
    const QSize draft((size.width() + side - 1) / side, (size.height() + side - 1) / side);
    if (draft_ == nullptr || draft_->size() != draft)
        draft_ = std::make_unique<QOpenGLFramebufferObject>(draft, fine_format());
    QElapsedTimer timer;
    timer.start();
    renderer_.draw(*draft_, QRect(QPoint(0, 0), draft), camera_, 0, TeaRenderer::Quality::Draft);
    gl().glFinish();
    const double cost_s =
        1e-9 * static_cast<double>(timer.nsecsElapsed()) / (draft.width() * draft.height());
    constexpr double kNewestShare = 0.3;
    pixel_cost_s_ += kNewestShare * (cost_s - pixel_cost_s_);
    draft_is_due_ = false;
}

void TeaView::refine(QSize size) {
    const double row_cost_s = std::max(pixel_cost_s_ * size.width(), 1e-9);
    const int rows = static_cast<int>(std::clamp(kRefinement_s / row_cost_s, 8.0, 1e5));
    const int end = std::min(row_ + rows, size.height());
    // From above, as pictures are read; OpenGL counts from below.
    renderer_.draw(*still_, QRect(0, size.height() - end, size.width(), end - row_), camera_, pass_,
                   TeaRenderer::Quality::Full);
    gl().glFinish();
    row_ = end;
    if (row_ < size.height()) return;
    row_ = 0;
    ++pass_;
}

void TeaView::present(QSize size) {
    gl().glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    const auto copy = [&](const QOpenGLFramebufferObject& from, const QRect& part, const QRect& to) {
        gl().glBindFramebuffer(GL_READ_FRAMEBUFFER, from.handle());
        gl().glBlitFramebuffer(part.x(), part.y(), part.x() + part.width(), part.y() + part.height(),
                               to.x(), to.y(), to.x() + to.width(), to.y() + to.height(),
                               GL_COLOR_BUFFER_BIT, part.size() == to.size() ? GL_NEAREST : GL_LINEAR);
    };
    const int ready = pass_ > 0 ? size.height() : row_;
    if (ready < size.height())
        copy(*draft_, QRect(QPoint(0, 0), draft_->size()), QRect(QPoint(0, 0), size));
    const QRect part(0, size.height() - ready, size.width(), ready);
    if (ready > 0) copy(*still_, part, part);
    gl().glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

/// Where milk would be poured, and the axis with the way the force turns.
void TeaView::draw_marks() {
    const auto ring = [&](const glm::vec2& middle_m, double radius_m, double from, double to) {
        constexpr int kCorners = 48;
        QPainterPath path;
        for (int i = 0; i <= kCorners; ++i) {
            const double angle = std::lerp(from, to, static_cast<double>(i) / kCorners);
            const glm::vec2 at =
                middle_m + glm::vec2(radius_m * std::cos(angle), radius_m * std::sin(angle));
            const QPointF seen = widget_position(at);
            i == 0 ? path.moveTo(seen) : path.lineTo(seen);
        }
        return path;
    };
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto stroke = [&](const QPainterPath& path, double opacity) {
        painter.setOpacity(opacity);
        painter.strokePath(path, QPen(QColor(0, 0, 0, 110), 3.2, Qt::SolidLine, Qt::RoundCap));
        painter.strokePath(path, QPen(QColor(255, 255, 255, 230), 1.4, Qt::SolidLine, Qt::RoundCap));
    };
    if (force_.on) {
        constexpr double kRadius_m = 0.009, kGap = 0.9;
        const glm::vec2 axis(force_.axis_m);
        const double turns = force_.swirl_rad_s2 < 0.0 ? -1.0 : 1.0;
        QPainterPath mark = ring(axis, kRadius_m, turns * kGap, turns * 2.0 * core::kPi);
        const glm::vec2 tip = axis + glm::vec2(kRadius_m, 0.0);
        for (const double side : {-0.0028, 0.0028}) {
            mark.moveTo(widget_position(tip));
            mark.lineTo(widget_position(tip + glm::vec2(side, -turns * 0.0036)));
        }
        mark.addEllipse(widget_position(axis), 1.2, 1.2);
        stroke(mark, 0.9);
    }
    if (does_ != Does::Nothing || !pointer_) return;
    if (const auto at = on_tea(*pointer_))
        stroke(ring(*at, shown_->settings.pour_radius_m, 0.0, 2.0 * core::kPi), 0.55);
}

QPointF TeaView::widget_position(const glm::vec2& on_tea_m) const {
    const float level_m = wanted_ != nullptr ? wanted_->settings.cup.level_m : liquid::Cup{}.level_m;
    return camera_.seen_at(glm::vec3(on_tea_m, level_m), size());
}

// ---- the hand

std::optional<glm::vec2> TeaView::on_tea(const QPointF& place) const {
    if (wanted_ == nullptr) return std::nullopt;
    return place_on_tea(camera_.through(place, size()), wanted_->settings.cup);
}

void TeaView::press(const QPointF& place, Qt::MouseButton button) {
    if (does_ != Does::Nothing) return;
    last_place_ = place;
    const auto at = on_tea(place);
    if (button == Qt::LeftButton && at) {
        does_ = Does::Pour;
        Q_EMIT poured(*at);
    } else {
        does_ = Does::Orbit;
        setCursor(Qt::ClosedHandCursor);
    }
    update();
}

/// Who pours past the glass goes on pouring where it was left.
void TeaView::drag(const QPointF& place) {
    if (does_ == Does::Pour) {
        if (const auto at = on_tea(place)) Q_EMIT poured(*at);
    } else if (does_ == Does::Orbit) {
        const QPointF way = place - last_place_;
        TeaCamera camera = camera_;
        camera.orbit(-kOrbit_deg_per_px * way.x(), kOrbit_deg_per_px * way.y());
        set_camera(camera);
    }
    last_place_ = place;
}

void TeaView::lift() {
    if (std::exchange(does_, Does::Nothing) == Does::Pour) Q_EMIT pouring_ended();
    set_cursor(last_place_);
    update();
}

void TeaView::set_cursor(const QPointF& place) {
    if (does_ == Does::Nothing) setCursor(on_tea(place) ? Qt::CrossCursor : Qt::OpenHandCursor);
}

void TeaView::mousePressEvent(QMouseEvent* event) {
    press(event->position(), event->button());
}

void TeaView::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    drag(event->position());
    set_cursor(event->position());
    if (does_ == Does::Nothing) update();
}

void TeaView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) lift();
}

void TeaView::wheelEvent(QWheelEvent* event) {
    constexpr double kStep = 1.12, kNotch = 120.0;
    TeaCamera camera = camera_;
    camera.zoom(std::pow(kStep, event->angleDelta().y() / kNotch));
    set_camera(camera);
    event->accept();
}

/// A pen is a mouse that presses with its tip, and orbits with its lower button.
void TeaView::tabletEvent(QTabletEvent* event) {
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
void TeaView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
}

void TeaView::leaveEvent(QEvent* event) {
    pointer_.reset();
    update();
    QOpenGLWidget::leaveEvent(event);
}

void TeaView::hideEvent(QHideEvent* event) {
    lift();
    QOpenGLWidget::hideEvent(event);
}

}  // namespace pastoso::tea
