#include "main/layers/layer_transform.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/said_value.hpp"
#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "core/error.hpp"
#include "core/thread_pool.hpp"
#include "dialogs/transform_dialog.hpp"
#include "document/layered_canvas.hpp"
#include "document/masking.hpp"
#include "layers/apart.hpp"
#include "main/canvas/dialog_corner.hpp"
#include "panels/pen/brush_panel.hpp"
#include "session/layer_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <QAction>
#include <QMainWindow>
#include <QPainter>
#include <QPolygonF>
#include <QStatusBar>

namespace pastoso::main {
namespace {

using commands::Command;

/// As fine as the paint in a frame is shown, along the longer side of the canvas.
constexpr int kPicture_px = 640;

/// Why the layer that is painted on cannot be changed; empty where it can.
QString problem_of(const document::LayerStack& layers) {
    try {
        document::check_paintable(layers, layers.active);
        return {};
    } catch (const core::InputError& error) {
        return appearance::shown_message(error.message());
    }
}

/// A layer's paint, of the whole canvas.
QImage picture_of(const film::FilmState& film, const pigment::Bands& ground) {
    const int longer = std::max(film.shape.width, film.shape.height);
    const double scale = std::min(1.0, static_cast<double>(kPicture_px) / longer);
    const session::LayerPicture found =
        session::layer_picture(film, ground, static_cast<int>(std::lround(scale * film.shape.width)),
                               static_cast<int>(std::lround(scale * film.shape.height)));
    return appearance::view_of_rgba(found.rgba, found.width, found.height)
        .convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

const film::FilmState& active_film(const document::Snapshot& painting) {
    return painting.active != nullptr ? *painting.active : painting.film;
}

/// Of a layer what can be seen in those cells: the tiles that they are in.
std::shared_ptr<const film::FilmState> film_around(const film::FilmState& layer,
                                                   const grid::Rect& cells) {
    auto around = std::make_shared<film::FilmState>(layer.shape, layer.cell_mm);
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        if (!grid::intersection(layer.shape.tile_cells(tile), cells).empty())
            layers::take_seen_tile(layer, tile, *around);
    return around;
}

/// The canvas with all other layers that are shown, in those cells; what is clipped to the active one
/// goes with it.
QImage picture_without_active(const document::Snapshot& painting, const grid::Rect& cells) {
    constexpr QColor kBareCanvas(233, 230, 222);
    document::LayerStack others = *painting.layers;
    others.layers[others.active].look.visible = false;
    for (document::Layer& layer : others.layers)
        if (layer.inactive != nullptr) layer.inactive = film_around(*layer.inactive, cells);
    core::ThreadPool pool;
    const QImage paint =
        picture_of(document::view_of(active_film(painting), painting.bare->support_mm, others, pool),
                   painting.ground);
    QImage picture(paint.size(), QImage::Format_ARGB32_Premultiplied);
    picture.fill(kBareCanvas);
    QPainter(&picture).drawImage(0, 0, paint);
    return picture;
}

/// What a choice of cells has in the middle of a pixel of a picture of the whole canvas.
std::uint8_t share_at(const grid::Mask& cells, const QSize& picture, int x, int y) {
    const grid::Shape& shape = cells.shape();
    return cells.at(static_cast<int>((x + 0.5) * shape.width / picture.width()),
                    static_cast<int>((y + 0.5) * shape.height / picture.height()));
}

/// A part of a picture of the whole canvas, as far as the paint there moves.
QImage moved_part(const QImage& picture, const QRect& part, const document::Snapshot& painting) {
    QImage cut = picture.copy(part);
    const document::Selection moved = document::without_masked(painting.selection, painting.masking);
    if (moved == nullptr) return cut;
    const QRect seen = part & picture.rect();
    for (int y = seen.top(); y <= seen.bottom(); ++y)
        for (int x = seen.left(); x <= seen.right(); ++x) {
            const std::uint8_t share = share_at(*moved, picture.size(), x, y);
            if (share == grid::kWhole) continue;
            const QPoint place = QPoint(x, y) - part.topLeft();
            QColor colour = cut.pixelColor(place);
            colour.setAlpha(colour.alpha() * share / grid::kWhole);
            cut.setPixelColor(place, colour);
        }
    return cut;
}

/// What moves of a picture of the whole canvas, as far as it is in the frame.
QImage part_in(const tools::TransformFrame& frame, const document::Snapshot& painting,
               const QImage& picture) {
    const auto pixel = [&](double place_mm, int pixels, int cells) {
        return static_cast<int>(std::lround(place_mm / painting.film.cell_mm * pixels / cells));
    };
    const grid::Shape& shape = painting.film.shape;
    const QPoint first(pixel(frame.corner_mm.x, picture.width(), shape.width),
                       pixel(frame.corner_mm.y, picture.height(), shape.height));
    const QSize size(pixel(frame.size_mm.x, picture.width(), shape.width),
                     pixel(frame.size_mm.y, picture.height(), shape.height));
    return moved_part(picture, QRect(first, size.expandedTo({1, 1})), painting);
}

/// Of the whole canvas: where paint stays that comes there. Null: everywhere.
QImage open_canvas(const document::Snapshot& painting, const QSize& size) {
    const document::Selection& masked = painting.masking.cells;
    if (masked == nullptr) return {};
    QImage open(size, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < open.height(); ++y)
        for (int x = 0; x < open.width(); ++x) {
            const bool is_masked = share_at(*masked, size, x, y) != 0;
            open.setPixel(x, y, is_masked ? qRgba(0, 0, 0, 0) : qRgba(0, 0, 0, 255));
        }
    return open;
}

}  // namespace

LayerTransform::LayerTransform(Studio& studio, panels::BrushPanel* brushes) : studio_(studio) {
    studio_.commands().on(Command::TransformLayer, [this](bool on) {
        if (on)
            begin();
        else
            cancel();
    });
    connect(brushes, &panels::BrushPanel::brush_taken, this, &LayerTransform::cancel);
    connect(&studio_.on_canvas().frame, &interactions::Frame::accepted, this, &LayerTransform::apply);
    connect(&studio_.on_canvas().frame, &interactions::Frame::cancelled, this, &LayerTransform::cancel);
    for (const auto told : {&interactions::Frame::corner_chosen, &interactions::Frame::corner_moved})
        connect(&studio_.on_canvas().frame, told, this, &LayerTransform::say_corner);
    connect(&studio_, &Studio::session_ends, this, &LayerTransform::end);
    connect(&studio_, &Studio::published, this,
            [this](const auto& painting, const auto& status) { follow(*painting, status); });
}

void LayerTransform::begin() {
    studio_.commands().action(Command::TransformLayer)->setChecked(false);
    if (studio_.easel().brush_is_lent())
        return studio_.report(
            tr("A recording is being played; the layers are yours when it has ended."));
    studio_.easel().release();
    studio_.catch_up();
    const auto painting = studio_.session().snapshot();
    const QString problem = problem_of(*painting->layers);
    if (!problem.isEmpty()) return studio_.report_refusal(problem);
    const grid::Rect cells = tools::painted_cells(*painting);
    if (cells.empty())
        return studio_.report(painting->selection == nullptr
                                  ? tr("There is no paint on this layer.")
                                  : tr("There is no paint of this layer in the selection."));
    transforming_ = active_part(*painting);
    studio_.commands().action(Command::TransformLayer)->setChecked(true);
    show(cells, *painting);
}

void LayerTransform::show(const grid::Rect& cells, const document::Snapshot& painting) {
    const tools::TransformFrame frame = tools::frame_around(cells, painting.film.cell_mm);
    studio_.on_canvas().frame.show(frame);
    const QImage paint = picture_of(active_film(painting), painting.ground);
    studio_.on_canvas().frame.show_picture(
        part_in(frame, painting, paint),
        part_in(frame, painting, picture_without_active(painting, cells)),
        open_canvas(painting, paint.size()));
    const document::CanvasSettings& canvas = painting.bare->settings;
    open_dialog(frame, {canvas.width_mm, canvas.height_mm});
    studio_.canvas().setFocus();
    Q_EMIT changed();
    studio_.report(tr(
        "Drag inside to move, a handle to scale, outside to turn (Shift: in steps), with Ctrl a corner "
        "or a side alone. Enter applies, Esc gives up."));
}

/// For those who do not see the mark.
void LayerTransform::say_corner() {
    const interactions::Frame& frame = studio_.on_canvas().frame;
    if (!frame.corner()) return appearance::say_value(studio_.canvas(), tr("No corner is chosen"));
    const std::array<QString, 4> names = {tr("Upper left corner"), tr("Upper right corner"),
                                          tr("Lower right corner"), tr("Lower left corner")};
    const glm::dvec2 place = tools::handle_mm(*frame.shown(), tools::kFrameCorners[*frame.corner()]);
    appearance::say_value(studio_.canvas(),
                          tr("%1 at %2, %3 mm")
                              .arg(names[*frame.corner()], appearance::shown_number(place.x, 1),
                                   appearance::shown_number(place.y, 1)));
}

/// The frame with its handles, on the canvas view.
QRect LayerTransform::frame_on_view(const tools::TransformFrame& frame) const {
    constexpr int kHandle_px = 12;
    QPolygonF handles;
    for (const glm::ivec2& side : tools::kFrameCorners)
        handles << studio_.canvas().widget_position(tools::handle_mm(frame, side));
    return handles.boundingRect().toAlignedRect().adjusted(-kHandle_px, -kHandle_px, kHandle_px,
                                                           kHandle_px);
}

void LayerTransform::open_dialog(const tools::TransformFrame& frame, const QSizeF& canvas_mm) {
    auto* dialog = new dialogs::TransformDialog(frame, canvas_mm, &studio_.window());
    dialog_ = dialog;
    // The keys stay with the canvas.
    dialog->setAttribute(Qt::WA_ShowWithoutActivating);
    connect(dialog, &dialogs::TransformDialog::changed, this,
            [this](const tools::TransformFrame& changed) { studio_.on_canvas().frame.show(changed); });
    connect(&studio_.on_canvas().frame, &interactions::Frame::dragged, dialog,
            &dialogs::TransformDialog::show_frame);
    connect(dialog, &QDialog::accepted, this, &LayerTransform::apply);
    connect(dialog, &QDialog::rejected, this, &LayerTransform::cancel);
    const QPoint place = place_beside(frame_on_view(frame), dialog->sizeHint(), studio_.canvas().size());
    dialog->move(studio_.canvas().mapToGlobal(place));
    dialog->show();
}

/// Nothing of the painting has changed so far, and nothing will.
bool LayerTransform::end() {
    if (!transforming_) return false;
    transforming_.reset();
    studio_.on_canvas().frame.show(std::nullopt);
    if (dialog_ != nullptr) {
        dialog_->disconnect(this);
        dialog_->hide();
        dialog_->deleteLater();
        dialog_.clear();
    }
    studio_.commands().action(Command::TransformLayer)->setChecked(false);
    Q_EMIT changed();
    return true;
}

bool LayerTransform::cancel() {
    if (!end()) return false;
    studio_.report(tr("The paint stays as it is."));
    return true;
}

void LayerTransform::apply() {
    if (!transforming_ || !studio_.on_canvas().frame.shown()) return;
    const document::LayerId layer = transforming_->layer;
    const tools::TransformFrame frame = *studio_.on_canvas().frame.shown();
    const auto wanted = tools::transform_of(frame, 1.0 / transforming_->bare->settings.px_per_mm);
    if (!frame.is_distorted() && !wanted) {
        cancel();
        return;
    }
    const core::Message problem = tools::problem_of(frame);
    if (!problem.empty()) return studio_.report_refusal(appearance::shown_message(problem));
    end();
    if (frame.is_distorted())
        studio_.easel().distort({layer, tools::distortion_of(frame)});
    else
        studio_.easel().transform({layer, *wanted});
    studio_.window().statusBar()->clearMessage();
}

/// A frame around paint of another layer, of what is selected no more, or masked, or of another canvas
/// is none.
void LayerTransform::follow(const document::Snapshot& painting, const session::Status& status) {
    if (!transforming_) return;
    const bool same = active_part(painting) == *transforming_ && problem_of(*painting.layers).isEmpty();
    if (!same || status.replaying) cancel();
}

}  // namespace pastoso::main
