#include "main/canvas/canvas_sizing.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/shown_number.hpp"
#include "dialogs/canvas_size_dialog.hpp"
#include "dialogs/rotate_dialog.hpp"
#include "dialogs/scale_dialog.hpp"
#include "panels/parts/status_readings.hpp"
#include "session/layer_painter.hpp"
#include "tools/canvas_resizing.hpp"
#include "tools/selecting.hpp"

#include <utility>

#include <QMainWindow>
#include <QPainter>

namespace pastoso::main {
namespace {

using commands::Command;

struct CanvasTurn {
    Command command;
    core::Orientation to;
};
constexpr CanvasTurn kTurns[] = {{Command::MirrorImageHorizontally, {true, 0}},
                                 {Command::MirrorImageVertically, {true, 2}},
                                 {Command::RotateImageRight, {false, 1}},
                                 {Command::RotateImageLeft, {false, 3}},
                                 {Command::RotateImageAround, {false, 2}}};

constexpr int kPicture_px = 220;
constexpr QColor kBareCanvas(233, 230, 222);

/// The painting by even light, small.
QImage small_picture(const document::Snapshot& painting) {
    const session::LayerPicture found =
        session::layer_picture(painting.film, painting.ground, kPicture_px, kPicture_px);
    QImage picture(found.width, found.height, QImage::Format_RGB32);
    picture.fill(kBareCanvas);
    QPainter(&picture).drawImage(0, 0, appearance::view_of_rgba(found.rgba, found.width, found.height));
    return picture;
}

}  // namespace

bool is_canvas_lent(Studio& studio) {
    const bool lent = studio.easel().brush_is_lent();
    if (lent)
        studio.report(
            CanvasSizing::tr("A recording is being played; the canvas is yours when it has ended."));
    return lent;
}

CanvasSizing::CanvasSizing(Studio& studio, Loading& loading, panels::StatusReadings* readings)
    : studio_(studio), loading_(loading), readings_(readings) {
    studio_.commands().on(Command::CanvasSize, [this](bool) { ask(); });
    studio_.commands().on(Command::ScaleImage, [this](bool) { ask_for_scale(); });
    studio_.commands().on(Command::CropToSelection, [this](bool) { crop_to_selection(); });
    studio_.commands().on(Command::RotateImage, [this](bool) { ask_for_rotation(); });
    for (const auto& [command, orientation] : kTurns)
        studio_.commands().on(command, [this, to = orientation](bool) { turn(to); });
    connect(&studio_, &Studio::session_begun, this, [this] { shown_bare_.reset(); });
    connect(&studio_, &Studio::published, this, [this](const auto& painting) {
        studio_.canvas().show_snapshot(painting, follow(painting->bare));
        readings_->show_canvas(painting->bare->settings);
    });
}

void CanvasSizing::ask() {
    if (is_canvas_lent(studio_)) return;
    studio_.catch_up();
    const auto painting = studio_.session().snapshot();
    dialogs::CanvasSizeDialog dialog(painting->bare->settings, small_picture(*painting),
                                     &studio_.window());
    if (dialog.exec() == QDialog::Accepted) resize(dialog.wanted());
}

void CanvasSizing::crop_to_selection() {
    if (is_canvas_lent(studio_)) return;
    studio_.session().wait_until_applied();
    const auto painting = studio_.session().snapshot();
    const auto cropped = tools::cropped_to(painting->selection, painting->bare->settings);
    if (cropped)
        resize(*cropped);
    else if (painting->selection != nullptr && tools::outlined_area(painting->selection).empty())
        studio_.report(tr("The selection is too soft to crop to: nothing is outlined."));
    else
        studio_.report(tr("The selection reaches over the whole canvas: there is nothing to cut."));
}

void CanvasSizing::turn(const core::Orientation& turn) {
    if (!is_canvas_lent(studio_)) studio_.easel().turn_canvas({turn});
}

void CanvasSizing::ask_for_scale() {
    if (is_canvas_lent(studio_)) return;
    studio_.catch_up();
    dialogs::ScaleDialog dialog(studio_.session().snapshot()->bare->settings, &studio_.window());
    if (dialog.exec() == QDialog::Accepted) studio_.easel().scale_canvas(dialog.wanted());
}

void CanvasSizing::ask_for_rotation() {
    if (is_canvas_lent(studio_)) return;
    studio_.catch_up();
    const auto painting = studio_.session().snapshot();
    dialogs::RotateDialog dialog(painting->bare->settings, small_picture(*painting),
                                 studio_.easel().hand().ruler(), &studio_.window());
    if (dialog.exec() == QDialog::Accepted) studio_.easel().rotate_canvas(dialog.wanted());
}

void CanvasSizing::resize(const document::ResizeCanvas& resize) {
    loading_.begin(
        tr("Making the canvas"), [this, resize, bare = studio_.session().snapshot()->bare](const auto&) {
            core::ThreadPool pool;
            return [this, made = document::resized_canvas(resize, bare, pool)] { put_up(made); };
        });
}

/// The hand waits until the paint lies on it: its millimetres are others then.
void CanvasSizing::put_up(const document::ResizedCanvas& canvas) {
    if (is_canvas_lent(studio_)) return;
    studio_.catch_up();
    if (shown_bare_ != canvas.before)
        return studio_.report(tr("Meanwhile the canvas has become another one; that keeps its size."));
    studio_.session().have_ready(canvas);
    studio_.easel().resize(canvas.resize);
    studio_.catch_up();
    if (shown_bare_ == canvas.before) return;
    const document::CanvasSettings& shown = shown_bare_->settings;
    studio_.report(tr("The canvas is %1 × %2 mm now; Undo brings back what it was.")
                       .arg(appearance::shown_number(shown.width_mm))
                       .arg(appearance::shown_number(shown.height_mm)));
}

/// Where the same canvas was cut, made larger, turned, rotated or scaled, guides follow what lies on it.
/// How far its middle came to lie from where it was is told, unless it was scaled. What a recording does
/// to them that is being played stands in the recording.
std::optional<glm::dvec2> CanvasSizing::follow(std::shared_ptr<const document::BareCanvas> bare) {
    const auto before = std::exchange(shown_bare_, std::move(bare));
    if (before == nullptr ||
        (before->settings == shown_bare_->settings && before->rotated_deg == shown_bare_->rotated_deg))
        return std::nullopt;
    const tools::CanvasMove move = tools::move_between(*before, *shown_bare_);
    Q_EMIT resized();
    if (move != tools::CanvasMove{} && !studio_.easel().brush_is_lent()) {
        studio_.easel().move_along(move);
        studio_.show_hand();
    }
    const bool same_cells = before->settings.px_per_mm == shown_bare_->settings.px_per_mm;
    if (move.scale != glm::dvec2(1.0) || !same_cells) return std::nullopt;
    return tools::shift_of_middle_mm(before->settings, move);
}

}  // namespace pastoso::main
