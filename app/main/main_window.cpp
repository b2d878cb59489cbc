#include "main/main_window.hpp"

#include "appearance/shown_message.hpp"
#include "main/window_parts.hpp"
#include "panels/layers/tracing_panel.hpp"
#include "panels/paint/medium_panel.hpp"
#include "panels/paint/thinning_slider.hpp"
#include "panels/references/reference_panel.hpp"
#include "panels/references/reference_view.hpp"
#include "pigment/user_pigments.hpp"

#include <QCloseEvent>

namespace pastoso::main {

MainWindow::MainWindow(const document::CanvasSettings& canvas, bool keeps_journal,
                       const KeptPreferences& preferences)
    : first_canvas_(std::in_place, canvas),
      studio_(*this),
      panels_(lay_out(studio_)),
      parts_(std::make_unique<WindowParts>(studio_, panels_, keeps_journal)) {
    WindowParts& parts = *parts_;
    connect(&parts.selection, &SelectionCommands::selecting_begins, &parts.transform,
            &LayerTransform::end);
    connect(&parts.selection, &SelectionCommands::selecting_begins, &parts.fills,
            &FillCommands::end_gradients);
    connect(&parts.fills, &FillCommands::gradients_begin, &parts.selection,
            &SelectionCommands::go_back_to_painting);
    connect(&parts.fills, &FillCommands::gradients_begin, &parts.transform, &LayerTransform::end);
    connect(&parts.masking, &MaskingCommands::masking_begins, &parts.selection,
            &SelectionCommands::go_back_to_painting);
    connect(&parts.masking, &MaskingCommands::masking_begins, &parts.fills,
            &FillCommands::end_gradients);
    connect(&parts.masking, &MaskingCommands::masking_begins, &parts.transform, &LayerTransform::end);
    connect(&parts.selection, &SelectionCommands::selecting_begins, &parts.masking,
            &MaskingCommands::go_back_to_painting);
    connect(&parts.fills, &FillCommands::gradients_begin, &parts.masking,
            &MaskingCommands::go_back_to_painting);
    connect(&parts.sizing, &CanvasSizing::resized, &parts.files, &ProjectFiles::show_title);
    connect(&parts.sizing, &CanvasSizing::resized, &parts.view, &ViewCommands::name_canvas);
    connect(&parts.files, &ProjectFiles::ground_wanted, &parts.fills, &FillCommands::tone_ground);
    connect(&parts.files, &ProjectFiles::about_to_keep, panels_.tracing, &panels::TracingPanel::finish);
    connect(&parts.files, &ProjectFiles::about_to_keep, &panels_.references->board(),
            &panels::ReferenceView::finish);
    connect(&parts.preferences, &PreferenceCommands::autosave_due, &parts.files,
            &ProjectFiles::save_by_itself);
    connect(&parts.place, &CanvasPlace::taking, &parts.view, &ViewCommands::leave_canvas_only);
    connect(&parts.place, &CanvasPlace::taken_by, &parts.files, &ProjectFiles::show_place);
    connect(&parts.workspaces, &WorkspaceCommands::arranging, &parts.view,
            &ViewCommands::leave_canvas_only);
    connect(&parts.start, &StartCommands::dismissed, &parts.tour, &TourCommands::canvas_freed);
    connect(&parts.tea, &TeaMode::other_wanted, &parts.tank, &TankMode::choose);
    connect(&parts.tank, &TankMode::tea_wanted, &parts.tea, &TeaMode::enter);
    connect(&parts.files, &ProjectFiles::about_to_keep, panels_.physics, &panels::MediumPanel::finish);
    connect(&parts.files, &ProjectFiles::about_to_keep, panels_.thinning,
            &panels::ThinningSlider::finish);
    studio_.commands().on(commands::Command::Quit, [this](bool) { close(); });
    parts.files.start(first_canvas_->take());
    first_canvas_.reset();
    parts.brushes.read();
    parts.workspaces.recall(parts.memory.recall());
    parts.paints.recall();
    parts.tubes.recall();
    parts.keys.recall();
    parts.preferences.recall(preferences);
    parts.pens.recall();
    parts.popup.recall();
    parts.brush_shelf.recall();
    studio_.easel().set_up();
    studio_.show_hand();
    studio_.show_published();
    for (const core::Message& fault : pigment::user_pigments().faults)
        studio_.report(appearance::shown_message(fault));
}

MainWindow::~MainWindow() = default;

void MainWindow::closeEvent(QCloseEvent* event) {
    event->ignore();  // also where asking fails
    event->setAccepted(parts_->exporting.may_stop() && parts_->again.may_stop() &&
                       parts_->files.may_discard());
    if (!event->isAccepted()) return;
    parts_->exporting.exporter().stop();
    parts_->again.stop();
    parts_->loading.cancel();
    parts_->place.give_back();
    parts_->view.leave_canvas_only();
    parts_->paints.remember();
    parts_->tubes.remember_palette();
    parts_->memory.remember();
    parts_->popup.remember();
    parts_->brush_shelf.remember();
    studio_.session().discard_journal();
}

void MainWindow::replay(const document::Recording& recording) {
    parts_->transform.end();
    parts_->files.replay(recording);
}

void MainWindow::open_file(const std::filesystem::path& file) {
    const QString path = QString::fromStdString(file.string());
    if (ProjectFiles::opens(path))
        parts_->files.open_painting(path);
    else
        parts_->files.replay_file(file);
}

}  // namespace pastoso::main
