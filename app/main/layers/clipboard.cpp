#include "main/layers/clipboard.hpp"

#include "appearance/picture_view.hpp"
#include "layers/apart.hpp"
#include "layers/extent.hpp"
#include "main/canvas/canvas_sizing.hpp"
#include "main/layers/picture_layers.hpp"
#include "session/layer_painter.hpp"

#include <utility>

#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QMimeData>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr QLatin1String kImage("application/x-qt-image");

/// Copied paint for whoever asks: its picture is made when somebody does.
class CopiedMime : public QMimeData {
  public:
    CopiedMime(document::CopiedPaint paint, const grid::Rect& area, const pigment::Bands& ground)
        : paint_(std::move(paint)), area_(area), ground_(ground) {}

    const document::CopiedPaint& paint() const { return paint_; }
    QStringList formats() const override { return {kImage}; }

  protected:
    QVariant retrieveData(const QString& format, QMetaType) const override {
        if (format != kImage) return {};
        if (picture_.isNull()) picture_ = made_picture();
        return picture_;
    }

  private:
    QImage made_picture() const {
        const grid::Shape shape{area_.width(), area_.height()};
        const film::FilmState part = layers::on_extent(*paint_, {shape, area_.x0, area_.y0});
        const session::LayerPicture picture =
            session::layer_picture(part, ground_, shape.width, shape.height);
        return appearance::view_of_rgba(picture.rgba, picture.width, picture.height).copy();
    }

    document::CopiedPaint paint_;
    grid::Rect area_;
    pigment::Bands ground_;
    mutable QImage picture_;
};

/// From where the copied paint lay to where its middle is to be.
glm::dvec2 way_mm(const film::FilmState& paint, const glm::dvec2& middle_mm) {
    const grid::Rect area = layers::painted_area(paint);
    return middle_mm - 0.5 * paint.cell_mm * glm::dvec2(area.x0 + area.x1, area.y0 + area.y1);
}

}  // namespace

Clipboard::Clipboard(Studio& studio, PictureLayers& pictures) : studio_(studio), pictures_(pictures) {
    studio_.commands().on(Command::Cut, [this](bool) { cut(); });
    studio_.commands().on(Command::Copy, [this](bool) { copy(active_layer()); });
    studio_.commands().on(Command::CopyMerged, [this](bool) { copy(0); });
    studio_.commands().on(Command::Paste, [this](bool) { paste(std::nullopt); });
    studio_.commands().on(Command::PasteAtCursor,
                          [this](bool) { paste(studio_.canvas().pointer_mm()); });
}

document::LayerId Clipboard::active_layer() const {
    const document::LayerStack& stack = *studio_.session().snapshot()->layers;
    return stack.layers[stack.active].id;
}

bool Clipboard::copy(document::LayerId layer) {
    if (is_canvas_lent(studio_)) return false;
    const auto before = studio_.session().snapshot()->copied;
    studio_.session().post(document::CopyPaint{layer});
    studio_.session().wait_until_applied();
    const auto painting = studio_.session().snapshot();
    if (painting->copied == before) return false;
    const grid::Rect area = layers::painted_area(*painting->copied);
    if (area.empty()) {
        studio_.report(tr("There is no paint to copy here."));
        return false;
    }
    QGuiApplication::clipboard()->setMimeData(new CopiedMime(painting->copied, area, painting->ground));
    studio_.report(tr("Copied; paste it as a layer, or as a picture in another program."));
    return true;
}

void Clipboard::cut() {
    const document::LayerId layer = active_layer();
    if (copy(layer)) studio_.session().post(document::ClearLayer{layer});
}

void Clipboard::paste(std::optional<glm::dvec2> middle_mm) {
    if (is_canvas_lent(studio_)) return;
    studio_.session().wait_until_applied();
    const document::CopiedPaint copied = studio_.session().snapshot()->copied;
    const QMimeData* held = QGuiApplication::clipboard()->mimeData();
    const auto* own = dynamic_cast<const CopiedMime*>(held);
    const bool holds_picture = held != nullptr && held->hasImage();
    if (copied && (!holds_picture || (own != nullptr && own->paint() == copied))) {
        const glm::dvec2 move_mm = middle_mm ? way_mm(*copied, *middle_mm) : glm::dvec2(0.0);
        studio_.session().post(document::PastePaint{tr("Pasted").toStdString(), move_mm.x, move_mm.y});
    } else if (holds_picture) {
        pictures_.paint_picture(appearance::picture_of(qvariant_cast<QImage>(held->imageData())),
                                tr("Pasted"));
    } else {
        studio_.report(tr("There is nothing to paste: no paint and no picture has been copied."));
    }
}

}  // namespace pastoso::main
