// The picture that is traced in MainWindow: below the paint, and in a panel beside the canvas.

#include "core/error.hpp"
#include "io/image.hpp"
#include "layers/picture_means.hpp"
#include "main/main_window.hpp"
#include "main/wait_cursor.hpp"
#include "panels/tracing_panel.hpp"
#include "project/picture_import.hpp"
#include "tools/colour_paint.hpp"

#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QMessageBox>

namespace pastoso::main {
namespace {

using commands::Command;

/// More is not seen of it, and the painting's file would grow by it.
constexpr int kMostSide_px = 4096;

pigment::Srgb8 srgb8(const QColor& colour) {
    return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
            static_cast<std::uint8_t>(colour.blue())};
}

}  // namespace

void MainWindow::connect_tracing() {
    commands_.on(Command::TracePicture, [this](bool) { ask_trace_picture(); });
    commands_.on(Command::RemoveTracing, [this](bool) { session_->post(document::LayTracing{}); });
    commands_.on(Command::ShowTracing, [this](bool shown) { canvas_->show_tracing(shown); });
    commands_.action(Command::ShowTracing)->setChecked(true);
    commands_.on(Command::FitTracing, [this](bool) {
        const auto tracing = session_->snapshot()->tracing;
        if (tracing == nullptr) return;
        const layers::Picture& picture = *tracing->picture;
        session_->post(document::SetTracing{
            project::fitted_place(picture.width, picture.height, session_->canvas()), tracing->opacity});
    });
    connect(tracing_, &panels::TracingPanel::moved, this, [this](const document::SetTracing& set) {
        const auto tracing = session_->snapshot()->tracing;
        if (tracing == nullptr) return;
        canvas_->preview_tracing(std::make_shared<const layers::Tracing>(
            layers::Tracing{tracing->picture, set.place, set.opacity}));
    });
    connect(tracing_, &panels::TracingPanel::rested, this,
            [this](const document::SetTracing& set) { session_->post(set); });
    connect(tracing_, &panels::TracingPanel::colour_picked, this, [this](const QColor& colour) {
        choose_paint(tools::colour_paint(srgb8(colour)));
        report(tr("Picked the colour of the picture: %1").arg(colour.name()));
    });
}

void MainWindow::trace_picture(const QString& path) {
    const WaitCursor waiting;
    layers::Picture picture =
        layers::reduced(io::read_picture(path.toStdString()).picture, kMostSide_px, kMostSide_px);
    const layers::PicturePlace place =
        project::fitted_place(picture.width, picture.height, session_->canvas());
    session_->post(
        document::LayTracing{std::make_shared<const layers::Picture>(std::move(picture)), place});
    commands_.action(Command::ShowTracing)->setChecked(true);
    canvas_->show_tracing(true);
}

void MainWindow::ask_trace_picture() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Trace a picture"), {}, tr("Pictures (%1);;All files (*)").arg(picture_endings()));
    if (path.isEmpty()) return;
    try {
        trace_picture(path);
    } catch (const core::InputError& error) {
        QMessageBox::warning(this, tr("Trace a picture"), QString::fromUtf8(error.what()));
    }
}

void MainWindow::show_tracing(const document::Snapshot& painting) {
    tracing_->show_tracing(painting.tracing);
    for (const Command command : {Command::ShowTracing, Command::FitTracing, Command::RemoveTracing})
        commands_.action(command)->setEnabled(painting.tracing != nullptr);
}

}  // namespace pastoso::main
