#include "main/layers/tracing_commands.hpp"

#include "files/image.hpp"
#include "layers/picture_means.hpp"
#include "main/files/picture_files.hpp"
#include "panels/layers/tracing_panel.hpp"
#include "project/picture_import.hpp"
#include "tools/colour_paint.hpp"

#include <utility>

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

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

TracingCommands::TracingCommands(Studio& studio, Loading& loading, panels::TracingPanel* panel)
    : studio_(studio), loading_(loading), panel_(panel) {
    studio_.commands().on(Command::TracePicture, [this](bool) { ask_trace_picture(); });
    studio_.commands().on(Command::RemoveTracing,
                          [this](bool) { studio_.session().post(document::LayTracing{}); });
    studio_.commands().on(Command::ShowTracing,
                          [this](bool shown) { studio_.canvas().show_tracing(shown); });
    studio_.commands().action(Command::ShowTracing)->setChecked(true);
    studio_.commands().on(Command::FitTracing, [this](bool) {
        const auto tracing = studio_.session().snapshot()->tracing;
        if (tracing == nullptr) return;
        const pigment::Picture& picture = *tracing->picture;
        studio_.session().post(document::SetTracing{
            project::fitted_place(picture.width, picture.height, studio_.session().canvas()),
            tracing->opacity});
    });
    connect(panel_, &panels::TracingPanel::moved, this, [this](const document::SetTracing& set) {
        const auto tracing = studio_.session().snapshot()->tracing;
        if (tracing == nullptr) return;
        studio_.canvas().preview_tracing(std::make_shared<const layers::Tracing>(
            layers::Tracing{tracing->picture, set.place, set.opacity}));
    });
    connect(panel_, &panels::TracingPanel::rested, this,
            [this](const document::SetTracing& set) { studio_.session().post(set); });
    connect(panel_, &panels::TracingPanel::colour_picked, this, [this](const QColor& colour) {
        studio_.choose_paint(tools::colour_paint(srgb8(colour)));
        studio_.report(tr("Picked the colour of the picture: %1").arg(colour.name()));
    });
    connect(&studio_, &Studio::published, this, [this](const auto& painting) { show(*painting); });
}

void TracingCommands::trace_picture(const QString& path) {
    loading_.begin(tr("Reading %1").arg(QFileInfo(path).fileName()),
                   [this, path](const core::Progress&) {
                       const auto picture = std::make_shared<const pigment::Picture>(layers::reduced(
                           files::read_picture(path.toStdString()).picture, kMostSide_px, kMostSide_px));
                       return [this, picture] { lay(picture); };
                   });
}

void TracingCommands::trace_picture(pigment::Picture picture) {
    lay(std::make_shared<const pigment::Picture>(
        layers::reduced(std::move(picture), kMostSide_px, kMostSide_px)));
}

void TracingCommands::lay(const std::shared_ptr<const pigment::Picture>& picture) {
    const layers::PicturePlace place =
        project::fitted_place(picture->width, picture->height, studio_.session().canvas());
    studio_.session().post(document::LayTracing{picture, place});
    studio_.commands().action(Command::ShowTracing)->setChecked(true);
    studio_.canvas().show_tracing(true);
}

void TracingCommands::ask_trace_picture() {
    const QString path =
        QFileDialog::getOpenFileName(&studio_.window(), tr("Trace a picture"), {},
                                     tr("Pictures (%1);;All files (*)").arg(picture_endings()));
    if (!path.isEmpty()) trace_picture(path);
}

void TracingCommands::show(const document::Snapshot& painting) {
    panel_->show_tracing(painting.tracing);
    for (const Command command : {Command::ShowTracing, Command::FitTracing, Command::RemoveTracing})
        studio_.commands().action(command)->setEnabled(painting.tracing != nullptr);
}

}  // namespace pastoso::main
