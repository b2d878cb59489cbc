#include "panels/pen/stroke_strip.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/screen_colours.hpp"
#include "appearance/shown_number.hpp"
#include "document/tool_sample.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QPainterPath>

namespace pastoso::panels {
namespace {

/// The rough stroke has a quarter of the cells, and less than a quarter of the work.
constexpr double kRoughCell_px = 2.0;
/// Air drives paint in many short steps, the more the finer the cells, and leaves no streaks as fine as
/// those of bristles.
constexpr double kBlownCells = 4.0;
constexpr int kRest_ms = 150;

constexpr int kMargin = 8;
constexpr double kRound = 4.0;

/// Words that are read over paint of any colour.
constexpr QColor kInk(0, 0, 0, 190), kPaper(255, 255, 255, 150);

/// The longest of 1, 2, 5, 10 ... mm that takes at most a fifth of the board.
double bar_mm(double board_mm) {
    const double most = board_mm / 5.0, decade = std::pow(10.0, std::floor(std::log10(most)));
    for (const double step : {5.0, 2.0})
        if (step * decade <= most) return step * decade;
    return decade;
}

}  // namespace

StrokeStrip::StrokeStrip(core::Tell tell, QWidget* parent)
    : QWidget(parent),
      painter_(
          [this](int number, const pigment::Image8& sample) {
              QMetaObject::invokeMethod(
                  this,
                  [this, number, image = appearance::view_of(sample).copy()] { take(number, image); });
          },
          std::move(tell)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    resting_.setSingleShot(true);
    resting_.setInterval(kRest_ms);
    connect(&resting_, &QTimer::timeout, this, [this] { want(true); });
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            [this] { update(); });
}

void StrokeStrip::show_tool(const brush::Preset& preset, document::ToolMark mark, double mark_mm) {
    if (preset == preset_ && mark == mark_ && mark_mm == mark_mm_) return;
    preset_ = preset;
    mark_ = mark;
    mark_mm_ = mark_mm;
    begin();
}

void StrokeStrip::set_caption(const QString& caption) {
    caption_ = caption;
    update();
}

void StrokeStrip::resizeEvent(QResizeEvent*) {
    begin();
}

void StrokeStrip::showEvent(QShowEvent*) {
    begin();
}

/// A fine stroke under way is given up; a rough one is shown first, so that a number that keeps moving
/// is followed on a slow machine, too.
void StrokeStrip::begin() {
    if (mark_mm_ <= 0.0 || !isVisible()) return;
    resting_.stop();
    if (fine_) painter_.cancel();
    want(false);
}

void StrokeStrip::want(bool fine) {
    const QSize pixels = size() * devicePixelRatioF();
    const double coarser = mark_ == document::ToolMark::Blow ? kBlownCells : 1.0;
    fine_ = fine;
    painter_.want({preset_,
                   mark_,
                   {.width_mm = board_mm(),
                    .width_px = pixels.width(),
                    .height_px = pixels.height(),
                    .cell_px = coarser * (fine ? 1.0 : kRoughCell_px) * devicePixelRatioF()},
                   ++latest_});
}

void StrokeStrip::take(int number, const QImage& image) {
    picture_ = image;
    update();
    const bool is_latest = number == latest_;
    if (is_latest && !fine_) resting_.start();
    Q_EMIT painted(is_latest && fine_);
}

double StrokeStrip::board_mm() const {
    return document::sample_width_mm(mark_mm_, width(), height());
}

void StrokeStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.fillRect(rect(), palette().window());
    QPainterPath frame;
    frame.addRoundedRect(rect(), kRound, kRound);
    painter.setClipPath(frame);
    if (picture_.isNull()) {
        painter.fillRect(rect(), palette().base());
        return;
    }
    painter.drawImage(rect(), appearance::shown(picture_));
    painter.setPen(kInk);
    if (!caption_.isEmpty())
        paint_words(painter, QRectF(rect()).adjusted(kMargin, kMargin, 0, 0),
                    Qt::AlignLeft | Qt::AlignTop, caption_);
    paint_scale(painter);
}

/// A bar of so many millimetres in the lower right corner.
void StrokeStrip::paint_scale(QPainter& painter) const {
    constexpr double kTick = 3.0;
    const double length_mm = bar_mm(board_mm());
    const double right = width() - kMargin, y = height() - kMargin;
    const double left = right - length_mm / board_mm() * width();
    const QPointF ends[] = {{left, y - kTick}, {left, y}, {right, y}, {right, y - kTick}};
    paint_words(
        painter, QRectF(left - 2.0 * kMargin, 0.0, right - left + 4.0 * kMargin, y - 2.0 * kTick),
        Qt::AlignHCenter | Qt::AlignBottom, tr("%1 mm").arg(appearance::shown_number(length_mm)));
    painter.drawPolyline(ends, 4);
}

void StrokeStrip::paint_words(QPainter& painter, const QRectF& room, int alignment,
                              const QString& words) const {
    const QRectF paper = painter.boundingRect(room, alignment, words).adjusted(-4, -1, 4, 1);
    QPainterPath label;
    label.addRoundedRect(paper, kRound, kRound);
    painter.fillPath(label, kPaper);
    painter.drawText(room, alignment, words);
}

}  // namespace pastoso::panels
