// Cutting MainWindow's canvas and making it larger: asked for, done, and what follows it.

#include "dialogs/canvas_size_dialog.hpp"
#include "main/main_window.hpp"
#include "main/wait_cursor.hpp"
#include "tools/canvas_resizing.hpp"

#include <utility>

#include <QAction>
#include <QPainter>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr int kPicture_px = 220;
constexpr QColor kBareCanvas(233, 230, 222);

/// The painting by even light, small.
QImage small_picture(const document::Snapshot& painting) {
    const session::LayerPicture found =
        session::layer_picture(painting.film, painting.ground, kPicture_px, kPicture_px);
    QImage picture(found.width, found.height, QImage::Format_RGB32);
    picture.fill(kBareCanvas);
    QPainter(&picture).drawImage(
        0, 0,
        QImage(found.rgba.data(), found.width, found.height, 4 * found.width, QImage::Format_RGBA8888));
    return picture;
}

}  // namespace

void MainWindow::connect_canvas_size() {
    commands_.on(Command::CanvasSize, [this](bool) { ask_canvas_size(); });
    commands_.on(Command::CropToSelection, [this](bool) { crop_to_selection(); });
}

void MainWindow::ask_canvas_size() {
    if (canvas_is_lent()) return;
    session_->wait_until_applied();
    show_published();
    const auto painting = session_->snapshot();
    dialogs::CanvasSizeDialog dialog(painting->bare->settings, small_picture(*painting), this);
    if (dialog.exec() == QDialog::Accepted) resize_canvas(dialog.wanted());
}

/// Says so.
bool MainWindow::canvas_is_lent() {
    if (easel_->brush_is_lent())
        report(tr("A recording is being played; the canvas is yours when it has ended."));
    return easel_->brush_is_lent();
}

void MainWindow::crop_to_selection() {
    if (canvas_is_lent()) return;
    session_->wait_until_applied();
    const auto painting = session_->snapshot();
    const auto cropped = tools::cropped_to(painting->selection, painting->bare->settings);
    if (cropped)
        resize_canvas(*cropped);
    else
        report(tr("The selection reaches over the whole canvas: there is nothing to cut."));
}

/// The hand waits until the canvas is there: its millimetres are others then.
void MainWindow::resize_canvas(const document::ResizeCanvas& resize) {
    const WaitCursor waiting;
    const auto before = shown_bare_;
    easel_->resize(resize);
    session_->wait_until_applied();
    show_published();
    if (shown_bare_ == before) return;
    const document::CanvasSettings& canvas = shown_bare_->settings;
    report(tr("The canvas is %1 × %2 mm now; Undo brings back what it was.")
               .arg(canvas.width_mm)
               .arg(canvas.height_mm));
}

/// Where the same canvas was cut or made larger, guides follow what lies on it, and the shift is told.
/// What a recording does to them that is being played stands in the recording.
std::optional<glm::dvec2> MainWindow::follow_cloth(std::shared_ptr<const document::BareCanvas> bare) {
    const auto before = std::exchange(shown_bare_, std::move(bare));
    if (before == nullptr || before->settings == shown_bare_->settings) return std::nullopt;
    const glm::dvec2 shift_mm = tools::shift_mm(before->settings, shown_bare_->settings);
    show_title();
    if (shift_mm != glm::dvec2(0.0) && !easel_->brush_is_lent()) {
        easel_->move_along(shift_mm);
        show_guides();
    }
    return shift_mm;
}

}  // namespace pastoso::main
