// The frame over MainWindow's canvas that moves, scales and turns the paint of a layer.

#include "core/error.hpp"
#include "dialogs/transform_dialog.hpp"
#include "main/main_window.hpp"
#include "panels/brush_panel.hpp"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QStatusBar>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr int kMargin_px = 16;

/// As fine as the paint in a frame is shown, along the longer side of the canvas.
constexpr int kPicture_px = 640;

/// Why the layer that is painted on cannot be changed; empty where it can.
QString problem_of(const document::LayerStack& layers) {
    try {
        document::check_paintable(layers, layers.active);
        return {};
    } catch (const core::InputError& error) {
        return QString::fromUtf8(error.what());
    }
}

/// The part of the layer's picture that is in the frame, what is not selected left out.
QImage picture_in(const tools::TransformFrame& frame, const document::Snapshot& painting) {
    const film::FilmState& film = painting.active != nullptr ? *painting.active : painting.film;
    const int longer = std::max(film.shape.width, film.shape.height);
    const double scale = std::min(1.0, static_cast<double>(kPicture_px) / longer);
    const session::LayerPicture found = session::layer_picture(
        film, painting.ground, static_cast<int>(std::lround(scale * film.shape.width)),
        static_cast<int>(std::lround(scale * film.shape.height)));
    QImage picture =
        QImage(found.rgba.data(), found.width, found.height, 4 * found.width, QImage::Format_RGBA8888)
            .copy();
    const double cells_x = static_cast<double>(film.shape.width) / found.width;
    const double cells_y = static_cast<double>(film.shape.height) / found.height;
    for (int y = 0; painting.selection != nullptr && y < found.height; ++y)
        for (int x = 0; x < found.width; ++x) {
            const bool chosen = painting.selection->at(static_cast<int>((x + 0.5) * cells_x),
                                                       static_cast<int>((y + 0.5) * cells_y)) != 0;
            if (!chosen) picture.setPixelColor(x, y, Qt::transparent);
        }
    const auto pixel = [&](double place_mm, double cells) {
        return static_cast<int>(std::lround(place_mm / film.cell_mm / cells));
    };
    const QPoint first(pixel(frame.corner_mm.x, cells_x), pixel(frame.corner_mm.y, cells_y));
    const QSize size(pixel(frame.size_mm.x, cells_x), pixel(frame.size_mm.y, cells_y));
    return picture.copy(QRect(first, size.expandedTo({1, 1})))
        .convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

}  // namespace

void MainWindow::connect_transform() {
    commands_.on(Command::TransformLayer, [this](bool on) {
        if (on)
            begin_transform();
        else
            give_up_transform();
    });
    connect(brushes_, &panels::BrushPanel::brush_taken, this, &MainWindow::give_up_transform);
    connect(canvas_, &view::CanvasView::frame_accepted, this, &MainWindow::apply_transform);
    connect(canvas_, &view::CanvasView::frame_given_up, this, &MainWindow::give_up_transform);
}

void MainWindow::begin_transform() {
    commands_.action(Command::TransformLayer)->setChecked(false);
    if (easel_->brush_is_lent())
        return report(tr("A recording is being played; the layers are yours when it has ended."));
    easel_->release();
    session_->wait_until_applied();
    show_published();
    const auto painting = session_->snapshot();
    const QString problem = problem_of(*painting->layers);
    if (!problem.isEmpty()) return report_refusal(problem);
    const grid::Rect cells = tools::painted_cells(*painting);
    if (cells.empty())
        return report(painting->selection == nullptr
                          ? tr("There is no paint on this layer.")
                          : tr("There is no paint of this layer in the selection."));
    transforming_ = {painting->layers->layers[painting->layers->active].id, painting->selection,
                     painting->bare};
    commands_.action(Command::TransformLayer)->setChecked(true);
    show_transform(tools::frame_around(cells, painting->film.cell_mm), *painting);
}

void MainWindow::show_transform(const tools::TransformFrame& frame, const document::Snapshot& painting) {
    canvas_->show_frame(frame);
    canvas_->show_in_frame(picture_in(frame, painting));
    const document::CanvasSettings& canvas = painting.bare->settings;
    open_transform_dialog(frame, {canvas.width_mm, canvas.height_mm});
    canvas_->setFocus();
    show_enabled(session_->status());
    report(
        tr("Drag inside to move, a handle to scale, outside to turn (Shift: in steps). Enter applies, "
           "Esc gives up."));
}

/// In the lower corner that is farther from the frame, where it hides little.
void MainWindow::open_transform_dialog(const tools::TransformFrame& frame, const QSizeF& canvas_mm) {
    auto* dialog = new dialogs::TransformDialog(frame, canvas_mm, this);
    transform_dialog_ = dialog;
    // The keys stay with the canvas.
    dialog->setAttribute(Qt::WA_ShowWithoutActivating);
    connect(dialog, &dialogs::TransformDialog::changed, this,
            [this](const tools::TransformFrame& changed) { canvas_->show_frame(changed); });
    connect(canvas_, &view::CanvasView::frame_dragged, dialog, &dialogs::TransformDialog::show_frame);
    connect(dialog, &QDialog::accepted, this, &MainWindow::apply_transform);
    connect(dialog, &QDialog::rejected, this, &MainWindow::give_up_transform);
    const QSize size = dialog->sizeHint();
    const bool frame_is_left = canvas_->widget_position(frame.centre_mm()).x() < 0.5 * canvas_->width();
    const int x = frame_is_left ? canvas_->width() - size.width() - kMargin_px : kMargin_px;
    const int y = canvas_->height() - size.height() - kMargin_px;
    dialog->move(canvas_->mapToGlobal(QPoint(x, y)));
    dialog->show();
}

/// Nothing of the painting has changed so far, and nothing will.
bool MainWindow::end_transform() {
    if (!transforming_) return false;
    transforming_.reset();
    canvas_->show_frame(std::nullopt);
    if (transform_dialog_ != nullptr) {
        transform_dialog_->disconnect(this);
        transform_dialog_->hide();
        transform_dialog_->deleteLater();
        transform_dialog_.clear();
    }
    commands_.action(Command::TransformLayer)->setChecked(false);
    show_enabled(session_->status());
    return true;
}

bool MainWindow::give_up_transform() {
    if (!end_transform()) return false;
    report(tr("The paint stays as it is."));
    return true;
}

void MainWindow::apply_transform() {
    if (!transforming_ || !canvas_->frame()) return;
    const document::LayerId layer = transforming_->layer;
    const auto wanted =
        tools::transform_of(*canvas_->frame(), 1.0 / transforming_->bare->settings.px_per_mm);
    if (!wanted) {
        give_up_transform();
        return;
    }
    end_transform();
    easel_->transform({layer, *wanted});
    statusBar()->clearMessage();
}

/// A frame around paint of another layer, of what is selected no more or of another canvas is none.
void MainWindow::follow_transform(const document::Snapshot& painting, const session::Status& status) {
    if (!transforming_) return;
    const document::LayerStack& layers = *painting.layers;
    const bool same = layers.layers[layers.active].id == transforming_->layer &&
                      painting.selection == transforming_->selection &&
                      painting.bare == transforming_->bare && problem_of(layers).isEmpty();
    if (!same || status.replaying) give_up_transform();
}

}  // namespace pastoso::main
