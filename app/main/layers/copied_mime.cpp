#include "main/layers/copied_mime.hpp"

#include "appearance/picture_view.hpp"
#include "document/layered_canvas.hpp"
#include "layers/apart.hpp"
#include "layers/extent.hpp"
#include "recordings/paint_piece.hpp"
#include "session/layer_painter.hpp"

#include <memory>
#include <utility>

namespace pastoso::main {
namespace {

constexpr QLatin1String kImage("application/x-qt-image");

/// As far as its tiles tell.
bool holds_paint(const film::FilmState& layer) {
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        if (layers::holds_paint(layer, tile)) return true;
    return false;
}

}  // namespace

CopiedMime::CopiedMime(document::CopiedPaint paint, const pigment::Bands& ground)
    : paint_(std::move(paint)), ground_(ground) {}

QStringList CopiedMime::formats() const {
    return QMimeData::formats() + QStringList{kPaintFormat, kImage};
}

QVariant CopiedMime::retrieveData(const QString& format, QMetaType type) const {
    if (format == kPaintFormat) return bytes();
    if (format != kImage) return QMimeData::retrieveData(format, type);
    if (picture_.isNull()) picture_ = made_picture();
    return picture_;
}

/// None where they are too many.
QByteArray CopiedMime::bytes() const {
    if (!bytes_) {
        bytes_ = QByteArray::fromStdString(recordings::piece_bytes(*paint_));
        if (bytes_->size() > qsizetype{kMostPaint_MB} * 1'000'000) bytes_->clear();
    }
    return *bytes_;
}

QImage CopiedMime::made_picture() const {
    const grid::Rect area = layers::painted_area(*paint_);
    if (area.empty()) return {};
    const grid::Shape shape{area.width(), area.height()};
    const film::FilmState part = layers::on_extent(*paint_, {shape, area.x0, area.y0});
    const session::LayerPicture picture =
        session::layer_picture(part, ground_, shape.width, shape.height);
    return appearance::view_of_rgba(picture.rgba, picture.width, picture.height).copy();
}

CopiedMime* copied_layer(const document::Snapshot& painting, document::LayerId layer) {
    const document::LayerStack& stack = *painting.layers;
    const film::FilmState& active = painting.active != nullptr ? *painting.active : painting.film;
    film::FilmState paint = *document::layers_apart(active, painting.bare->support_mm,
                                                    stack)[document::place_of(stack, layer)];
    paint.strata.evaporated = 0;
    if (!holds_paint(paint)) return nullptr;
    return new CopiedMime(std::make_shared<const film::FilmState>(std::move(paint)), painting.ground);
}

}  // namespace pastoso::main
