#include "start/support_picture.hpp"

#include "appearance/picture_view.hpp"
#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "recordings/canvas_support.hpp"
#include "shade/render.hpp"

#include <QImage>
#include <QPainter>

namespace pastoso::start {
namespace {

constexpr double kPxPerMm = 6.0;

const QColor kEdge(120, 118, 112);

}  // namespace

QImage support_picture(const std::string& support, const QSize& size_px) {
    core::ThreadPool pool(1);
    document::CanvasSettings canvas;
    canvas.width_mm = size_px.width() / kPxPerMm;
    canvas.height_mm = size_px.height() / kPxPerMm;
    canvas.px_per_mm = kPxPerMm;
    canvas.support = support;
    const document::Snapshot bare = recordings::make_painting(canvas, pool)->snapshot();
    const pigment::Image8 picture =
        pigment::encode_srgb8(shade::render(bare.film, bare.ground, bare.film.shape.cells(), {}, pool));
    return appearance::view_of(picture).copy();
}

QPixmap edged(QImage picture) {
    QPainter painter(&picture);
    painter.setPen(QPen(kEdge, 2.0));
    painter.drawRect(picture.rect().adjusted(1, 1, -1, -1));
    painter.end();
    return QPixmap::fromImage(picture);
}

QPixmap sheet_picture(const QSizeF& size_mm, double px_per_mm, const QSize& room, const QImage& support,
                      double pixel_ratio) {
    QPixmap picture(room * pixel_ratio);
    picture.setDevicePixelRatio(pixel_ratio);
    picture.fill(Qt::transparent);
    const QSizeF sheet = px_per_mm * size_mm;
    const QPointF corner(0.5 * (room.width() - sheet.width()), 0.5 * (room.height() - sheet.height()));
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(kEdge, 1.0));
    painter.setBrush(QBrush(support));
    painter.drawRect(QRectF(corner, sheet).adjusted(0.5, 0.5, -0.5, -0.5));
    return picture;
}

}  // namespace pastoso::start
