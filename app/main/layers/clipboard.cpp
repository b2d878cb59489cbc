#include "main/layers/clipboard.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/shown_message.hpp"
#include "core/error.hpp"
#include "layers/apart.hpp"
#include "main/canvas/canvas_sizing.hpp"
#include "main/files/picture_files.hpp"
#include "main/layers/copied_mime.hpp"
#include "main/layers/picture_layers.hpp"
#include "main/wait_cursor.hpp"
#include "recordings/paint_piece.hpp"

#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QMimeData>

namespace pastoso::main {
namespace {

using commands::Command;

/// Whether cells of the paint lie on a canvas, within a cell; both begin in the same corner.
bool lie_on(const film::FilmState& canvas, const grid::Rect& cells, double cell_mm) {
    return cell_mm * (cells.x1 - 1) <= canvas.cell_mm * canvas.shape.width &&
           cell_mm * (cells.y1 - 1) <= canvas.cell_mm * canvas.shape.height;
}

/// From where the copied paint lay to where it is to be.
glm::dvec2 way_mm(const film::FilmState& paint, const film::FilmState& canvas,
                  std::optional<glm::dvec2> middle_mm) {
    const grid::Rect area = layers::painted_area(paint);
    if (!middle_mm && lie_on(canvas, area, paint.cell_mm)) return {0.0, 0.0};
    const glm::dvec2 middle_of_canvas_mm =
        0.5 * canvas.cell_mm * glm::dvec2(canvas.shape.width, canvas.shape.height);
    return middle_mm.value_or(middle_of_canvas_mm) -
           0.5 * paint.cell_mm * glm::dvec2(area.x0 + area.x1, area.y0 + area.y1);
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
    if (layers::painted_area(*painting->copied).empty()) {
        studio_.report(tr("There is no paint to copy here."));
        return false;
    }
    QGuiApplication::clipboard()->setMimeData(new CopiedMime(painting->copied, painting->ground));
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
    const bool holds_paint = held != nullptr && held->hasFormat(kPaintFormat);
    const bool holds_other = held != nullptr && (held->hasImage() || !local_files(*held).isEmpty());
    const bool is_kept =
        copied && ((!holds_paint && !holds_other) || (own != nullptr && own->paint() == copied));
    if (is_kept || (holds_paint && bring(*held, tr("The clipboard"))))
        paste_copied(middle_mm);
    else if (holds_other)
        paste_pictures(*held);
    else if (!holds_paint)
        studio_.report(tr("There is nothing to paste: no paint and no picture has been copied."));
}

void Clipboard::paste_dragged(const QMimeData& dragged, std::optional<glm::dvec2> middle_mm) {
    if (is_canvas_lent(studio_)) return;
    studio_.session().wait_until_applied();
    if (bring(dragged, tr("What was dragged here"))) paste_copied(middle_mm);
}

void Clipboard::paste_pictures(const QMimeData& held) {
    const QStringList files = local_files(held);
    if (!files.isEmpty()) return pictures_.paint_pictures(files);
    pictures_.paint_picture(appearance::picture_of(qvariant_cast<QImage>(held.imageData())),
                            tr("Pasted"));
}

bool Clipboard::bring(const QMimeData& held, const QString& name) {
    const WaitCursor waiting;
    const QByteArray bytes = held.data(kPaintFormat);
    if (bytes.isEmpty()) {
        studio_.report(tr("The copied paint is too large to go to another painting as paint (at most "
                          "%1 MB); a picture of it goes.")
                           .arg(kMostPaint_MB));
        return false;
    }
    try {
        const recordings::PaintPiece piece = recordings::piece_of(
            {bytes.constData(), static_cast<std::size_t>(bytes.size())}, name.toStdString());
        const document::BringPaint brought{piece.paint};
        // Pasted once more, it need not be in the recording again.
        if (document::BringPaint{studio_.session().snapshot()->copied} != brought)
            studio_.session().post(brought);
        return true;
    } catch (const core::InputError& error) {
        studio_.report_refusal(appearance::shown_message(error.message()));
        return false;
    }
}

void Clipboard::paste_copied(std::optional<glm::dvec2> middle_mm) {
    studio_.session().wait_until_applied();
    const auto painting = studio_.session().snapshot();
    const glm::dvec2 move_mm = way_mm(*painting->copied, painting->film, middle_mm);
    studio_.session().post(document::PastePaint{tr("Pasted").toStdString(), move_mm.x, move_mm.y});
}

}  // namespace pastoso::main
