#include "screen/raster_screen.hpp"

#include "core/error.hpp"
#include "screen/raster_overlay.hpp"
#include "screen/window_pixels.hpp"

#include <utility>

#include <QPainter>

namespace pastoso::screen {
namespace {

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
              [this](Frame& frame, const std::string& fault) {
                  frame.fault = fault;
                  hand_over(std::move(frame));
              }) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &RasterScreen::refresh);
}

RasterScene RasterScreen::wanted_scene() const {
    return {host_.sight(), host_.view_transform(), window_px(*this), ground_colour(),
            appearance::screen_colours().of_painting()};
}

/// What nobody sees is not drawn.
void RasterScreen::refresh() {
    if (!isVisible()) return;
    RasterScene wanted = wanted_scene();
    if (wanted.sight.painting != nullptr && !wanted.window_px.isEmpty() && wanted != asked_) {
        asked_ = wanted;
        const Quality quality = first_quality(wanted);
        worker_.replace(Frame{std::move(wanted), quality});
    }
    update();
}

/// A draft where all of the window is another and would hold up the hand.
Quality RasterScreen::first_quality(const RasterScene& scene) const {
    constexpr double kMostSamples = 2e6;
    const double pixels = 1.0 * scene.window_px.width() * scene.window_px.height();
    const bool quick = pixels * samples_per_pixel(Quality::Full, scene.view.zoom) < kMostSamples;
    const auto shape = [](const RasterScene& of) { return of.sight.painting->film.shape; };
    const bool painted_on =
        frame_ && shape(frame_->scene) == shape(scene) && same_place(frame_->scene, scene);
    return quick || painted_on ? Quality::Full : Quality::Plain;
}

/// Not drawn yet: the view comes to suit the canvas first.
void RasterScreen::begin_other_canvas() {
    asked_.reset();
}

bool RasterScreen::finished() const {
    if (host_.sight().painting == nullptr) return true;
    return frame_ && frame_->quality == Quality::Full && frame_->scene == wanted_scene();
}

const document::Snapshot* RasterScreen::shown() const {
    return frame_ ? frame_->scene.sight.painting.get() : nullptr;
}

void RasterScreen::make(Frame& frame) {
    if (frame.refines)
        picture_.refine(pool_);
    else
        picture_.show(frame.scene, frame.quality, pool_);
    frame.quality = picture_.is_draft() ? Quality::Plain : Quality::Full;
    frame.image = picture_.image();
    frame.scale_top_mm = picture_.scale_top_mm();
    hand_over(std::move(frame));
}

void RasterScreen::hand_over(Frame frame) {
    {
        const std::lock_guard lock(mutex_);
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
    frame_ = std::move(made);
    if (frame_->scene.sight.look == Look::Height) host_.scale_shown(frame_->scale_top_mm);
    // Strip by strip: what the hand does meanwhile comes first.
    if (frame_->quality != Quality::Full && frame_->scene == asked_)
        worker_.replace(Frame{frame_->scene, Quality::Full, true});
    refresh();
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
    painter.drawImage(QPoint(0, 0), frame_->image);
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
