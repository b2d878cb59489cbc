#include "help/tour_frame.hpp"

#include <QPainter>
#include <QRegion>

namespace pastoso::help {
namespace {

constexpr int kOutside_px = 1, kInside_px = 2;

QRegion around(const QRect& place) {
    const QRect outer = place.adjusted(-kOutside_px, -kOutside_px, kOutside_px, kOutside_px);
    return QRegion(outer).subtracted(place.adjusted(kInside_px, kInside_px, -kInside_px, -kInside_px));
}

}  // namespace

TourFrame::TourFrame(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

/// An empty mask would be none.
void TourFrame::show_around(const QList<QRect>& places) {
    setGeometry(parentWidget()->rect());
    QRegion frames;
    for (const QRect& place : places)
        if (!place.isEmpty()) frames += around(place);
    frames &= rect();
    setMask(frames);
    setVisible(!frames.isEmpty());
}

void TourFrame::paintEvent(QPaintEvent*) {
    QPainter(this).fillRect(rect(), palette().color(QPalette::Highlight));
}

}  // namespace pastoso::help
