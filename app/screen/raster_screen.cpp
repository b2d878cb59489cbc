#include "screen/raster_screen.hpp"

#include "core/error.hpp"
#include "screen/raster_overlay.hpp"
#include "screen/squint.hpp"
#include "screen/window_pixels.hpp"

#include <utility>

#include <QPainter>
#include <QPicture>

namespace pastoso::screen {
namespace {

/// Drafts are left for so long: while they come one after another, as under a hand that paints, to
/// refine one would hold up the next.
constexpr int kRest_ms = 60;

QColor colour_of(const Rgb& rgb) {
    return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

/// From the pixels of one view to those of another.
QTransform moved(const ViewTransform& from, const ViewTransform& to) {
    const glm::dvec2 origin = moved_px(from, to, {0.0, 0.0});
    const glm::dvec2 right = moved_px(from, to, {1.0, 0.0}) - origin;
    const glm::dvec2 down = moved_px(from, to, {0.0, 1.0}) - origin;
    return {right.x, right.y, down.x, down.y, origin.x, origin.y};
}

}  // namespace

RasterScreen::RasterScreen(ScreenHost& host, QWidget& parent)
    : QWidget(&parent),
      host_(host),
      worker_([this](Frame& frame) { make(frame); },
              [this](Frame& frame, const core::Message& fault) {
                  frame.fault = fault;
                  hand_over(std::move(frame));
              }) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    rest_.setSingleShot(true);
    rest_.setInterval(kRest_ms);
    connect(&rest_, &QTimer::timeout, this, &RasterScreen::refine);
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &RasterScreen::damage_all);
}

RasterScene RasterScreen::wanted_scene() const {
    return {host_.sight(),
            host_.view_transform(),
            window_px(*this),
            ground_colour(),
            appearance::screen_colours().of_painting(),
            squint_px(*this)};
}

/// What nobody sees is not drawn.
void RasterScreen::refresh() {
    if (!isVisible()) return;
    RasterScene wanted = wanted_scene();
    if (wanted.sight.painting != nullptr && !wanted.window_px.isEmpty() && wanted != asked_) {
        asked_ = wanted;
        worker_.replace(Frame{std::move(wanted)});
    }
    look_at_overlay();
}

/// Later, and once for all that has happened until then: whoever asks for it may be in the middle of a
/// change, or of its end.
void RasterScreen::look_at_overlay() {
    if (std::exchange(looks_at_overlay_, true)) return;
    QMetaObject::invokeMethod(this, &RasterScreen::update_overlay, Qt::QueuedConnection);
}

void RasterScreen::damage_all() {
    refresh();
    update();
}

/// Otherwise it is drawn moved, everywhere, until there is one from there.
bool RasterScreen::is_where_it_is_seen() const {
    return frame_ && frame_->scene.view == host_.view_transform() &&
           frame_->scene.window_px == window_px(*this);
}

/// With room for lines and their soft edges.
QRect RasterScreen::overlay_points() const {
    constexpr int kRoom = 3;
    QPicture drawn;
    QPainter painter(&drawn);
    RasterOverlay overlay(painter, devicePixelRatioF());
    host_.draw_over(*frame_->scene.sight.painting, overlay);
    painter.end();
    return drawn.boundingRect().adjusted(-kRoom, -kRoom, kRoom, kRoom);
}

void RasterScreen::update_overlay() {
    looks_at_overlay_ = false;
    if (!is_where_it_is_seen()) return update();
    const QRect before = std::exchange(overlay_, overlay_points());
    update(QRegion(before) + overlay_);
}

void RasterScreen::update_picture(const QRegion& changed_px) {
    if (!is_where_it_is_seen()) return update();
    const double point_px = devicePixelRatioF();
    for (const QRect& part : changed_px)
        update(QRectF(part.x() / point_px, part.y() / point_px, part.width() / point_px,
                      part.height() / point_px)
                   .toAlignedRect());
}

/// Not drawn yet: the view comes to suit the canvas first.
void RasterScreen::begin_other_canvas() {
    asked_.reset();
}

bool RasterScreen::finished() const {
    if (host_.sight().painting == nullptr) return true;
    return frame_ && !frame_->is_draft && frame_->scene == wanted_scene();
}

const document::Snapshot* RasterScreen::shown() const {
    return frame_ ? frame_->scene.sight.painting.get() : nullptr;
}

void RasterScreen::make(Frame& frame) {
    if (frame.refines)
        picture_.refine(pool_);
    else
        frame.is_drafted_now = picture_.show(frame.scene, pool_);
    frame.is_draft = picture_.is_draft();
    for (const QRect& part : picture_.take_changed())
        frame.changed.push_back({part.topLeft(), picture_.image().copy(part)});
    frame.scale_top_mm = picture_.scale_top_mm();
    hand_over(std::move(frame));
}

void RasterScreen::hand_over(Frame frame) {
    {
        const std::lock_guard lock(mutex_);
        if (made_)
            frame.changed.insert(frame.changed.begin(), made_->changed.begin(), made_->changed.end());
        made_ = std::move(frame);
    }
    QMetaObject::invokeMethod(this, &RasterScreen::take_frame, Qt::QueuedConnection);
}

void RasterScreen::take_frame() {
    std::optional<Frame> made;
    {
        const std::lock_guard lock(mutex_);
        made = std::exchange(made_, std::nullopt);
    }
    if (!made) return;
    if (!made->fault.empty()) throw core::InputError(made->fault);
    const bool moved = !frame_ || frame_->scene.view != made->scene.view ||
                       frame_->scene.window_px != made->scene.window_px;
    frame_ = std::move(made);
    const QRegion changed = put_in(*frame_);
    frame_->changed.clear();
    if (moved)
        update();
    else
        update_picture(changed);
    if (frame_->scene.sight.look == Look::Height) host_.scale_shown(frame_->scale_top_mm);
    if (frame_->is_drafted_now)
        rest_.start();
    else if (!rest_.isActive())
        refine();
    refresh();
}

/// Where the window has another size, all of it is another picture.
QRegion RasterScreen::put_in(const Frame& made) {
    if (shown_.size() != made.scene.window_px)
        shown_ = QImage(made.scene.window_px, QImage::Format_RGB32);
    QRegion changed;
    QPainter onto(&shown_);
    onto.setCompositionMode(QPainter::CompositionMode_Source);
    for (const PicturePart& part : made.changed) {
        onto.drawImage(part.place, part.pixels);
        changed += QRect(part.place, part.pixels.size());
    }
    return changed;
}

/// Strip by strip: what the hand does meanwhile comes first.
void RasterScreen::refine() {
    if (frame_ && frame_->is_draft && frame_->scene == asked_)
        worker_.replace(Frame{frame_->scene, true});
}

void RasterScreen::resizeEvent(QResizeEvent*) {
    refresh();
}

void RasterScreen::showEvent(QShowEvent*) {
    refresh();
}

void RasterScreen::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    draw(painter);
    // When what was drawn has gone to the windowing system.
    QMetaObject::invokeMethod(
        this, [this] { host_.frame_shown(); }, Qt::QueuedConnection);
}

/// What is there lies where it is seen now, until that has been made.
void RasterScreen::draw(QPainter& painter) {
    painter.fillRect(rect(), colour_of(ground_colour()));
    if (!frame_) return;
    const double point_px = devicePixelRatioF();
    painter.save();
    painter.scale(1.0 / point_px, 1.0 / point_px);
    const QTransform way = moved(frame_->scene.view, host_.view_transform());
    painter.setRenderHint(QPainter::SmoothPixmapTransform, way.type() > QTransform::TxTranslate);
    painter.setTransform(way, true);
    painter.drawImage(QPoint(0, 0), shown_);
    painter.restore();
    RasterOverlay overlay(painter, point_px);
    host_.draw_over(*frame_->scene.sight.painting, overlay);
}

QImage RasterScreen::picture() {
    QImage image(window_px(*this), QImage::Format_RGB32);
    image.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&image);
    draw(painter);
    return image;
}

}  // namespace pastoso::screen
