#include "main/main_window.hpp"

#include "main/canvas/canvas_sizing.hpp"
#include "main/canvas/navigation.hpp"
#include "main/canvas/range_selection.hpp"
#include "main/canvas/selection_commands.hpp"
#include "main/canvas/undo_commands.hpp"
#include "main/canvas/view_commands.hpp"
#include "main/files/dropped_files.hpp"
#include "main/files/exporting.hpp"
#include "main/files/project_files.hpp"
#include "main/files/recorder.hpp"
#include "main/files/start_commands.hpp"
#include "main/layers/layer_commands.hpp"
#include "main/layers/layer_pictures.hpp"
#include "main/layers/layer_transform.hpp"
#include "main/layers/picture_layers.hpp"
#include "main/layers/tracing_commands.hpp"
#include "main/liquids/tank_mode.hpp"
#include "main/liquids/tea_mode.hpp"
#include "main/paint/light_choice.hpp"
#include "main/paint/paint_memory.hpp"
#include "main/paint/paint_picking.hpp"
#include "main/paint/well_commands.hpp"
#include "main/pen/brush_jar.hpp"
#include "main/pen/guide_commands.hpp"
#include "main/pen/hand_controls.hpp"
#include "main/pen/pen_commands.hpp"
#include "main/pen/popup_commands.hpp"
#include "main/program/key_commands.hpp"
#include "main/program/preference_commands.hpp"
#include "main/program/window_memory.hpp"
#include "panels/layers/tracing_panel.hpp"
#include "panels/paint/medium_panel.hpp"
#include "pigment/user_pigments.hpp"

#include <QCloseEvent>
#include <QDockWidget>

namespace pastoso::main {

/// One member for each concern. What is published is shown in this order.
struct MainWindow::Parts {
    Parts(Studio& studio, const PanelSet& panels, bool keeps_journal)
        : sizing(studio, panels.readings),
          layers(studio, panels.layers, panels.docks.at(commands::Command::LayersPanel)),
          layer_pictures(studio, panels.layers, panels.docks.at(commands::Command::LayersPanel)),
          selection(studio, panels.brushes, panels.readings),
          ranges(studio),
          tracing(studio, panels.tracing),
          well(studio, panels.well),
          hand(studio, panels),
          brushes(studio, panels.brushes, panels.curves),
          guides(studio, panels.guides),
          transform(studio, panels.brushes),
          undo(studio, panels.history, transform),
          picking(studio),
          pens(studio),
          popup(studio, brushes, panels.colours),
          files(studio, keeps_journal),
          start(studio, files),
          view(studio, panels.readings),
          navigation(studio, panels.navigator, panels.docks.at(commands::Command::NavigatorPanel)),
          light(studio, panels.stand, panels.lights),
          pictures(studio),
          dropped(studio, files, pictures, tracing),
          exporting(studio, files, light),
          recorder(studio, panels.recorder),
          paints(studio, panels.colours),
          memory(studio, panels, light, undo, well, start),
          keys(studio),
          preferences(studio, undo),
          place(studio, panels.readings),
          tea(studio, pictures, place),
          tank(studio, pictures, place) {}

    CanvasSizing sizing;
    LayerCommands layers;
    LayerPictures layer_pictures;
    SelectionCommands selection;
    RangeSelection ranges;
    TracingCommands tracing;
    WellCommands well;
    HandControls hand;
    BrushJar brushes;
    GuideCommands guides;
    LayerTransform transform;
    UndoCommands undo;
    PaintPicking picking;
    PenCommands pens;
    PopupCommands popup;
    ProjectFiles files;
    StartCommands start;
    ViewCommands view;
    Navigation navigation;
    LightChoice light;
    PictureLayers pictures;
    DroppedFiles dropped;
    Exporting exporting;
    Recorder recorder;
    PaintMemory paints;
    WindowMemory memory;
    KeyCommands keys;
    PreferenceCommands preferences;
    CanvasPlace place;
    TeaMode tea;
    TankMode tank;
};

MainWindow::MainWindow(const document::CanvasSettings& canvas, bool keeps_journal,
                       const KeptPreferences& preferences)
    : studio_(*this),
      panels_(lay_out(studio_)),
      parts_(std::make_unique<Parts>(studio_, panels_, keeps_journal)) {
    Parts& parts = *parts_;
    connect(&parts.selection, &SelectionCommands::drawing_begins, &parts.transform,
            &LayerTransform::end);
    connect(&parts.sizing, &CanvasSizing::resized, &parts.files, &ProjectFiles::show_title);
    connect(&parts.files, &ProjectFiles::about_to_keep, panels_.tracing, &panels::TracingPanel::finish);
    connect(&parts.preferences, &PreferenceCommands::autosave_due, &parts.files,
            &ProjectFiles::save_by_itself);
    connect(&parts.place, &CanvasPlace::taking, &parts.view, &ViewCommands::leave_canvas_only);
    connect(&parts.tea, &TeaMode::other_wanted, &parts.tank, &TankMode::choose);
    connect(&parts.tank, &TankMode::tea_wanted, &parts.tea, &TeaMode::enter);
    connect(&parts.files, &ProjectFiles::about_to_keep, panels_.physics, &panels::MediumPanel::finish);
    commands().on(commands::Command::Quit, [this](bool) { close(); });
    parts.files.start(canvas);
    parts.brushes.read();
    parts.memory.recall();
    parts.paints.recall();
    parts.keys.recall();
    parts.preferences.recall(preferences);
    parts.pens.recall();
    parts.popup.recall();
    easel().set_up();
    studio_.show_hand();
    studio_.show_published();
    for (const std::string& fault : pigment::user_pigments().faults)
        studio_.report(QString::fromStdString(fault));
}

MainWindow::~MainWindow() = default;

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(parts_->exporting.may_stop() && parts_->files.may_discard());
    if (!event->isAccepted()) return;
    parts_->exporting.exporter().stop();
    parts_->place.give_back();
    parts_->view.leave_canvas_only();
    parts_->paints.remember();
    parts_->memory.remember();
    parts_->popup.remember();
    session().discard_journal();
}

// ---- what the parts do

void MainWindow::new_canvas(const document::CanvasSettings& canvas) {
    parts_->files.new_canvas(canvas);
}

void MainWindow::open_painting(const QString& path) {
    parts_->files.open_painting(path);
}

void MainWindow::open_picture(const QString& path) {
    parts_->files.open_picture(path);
}

void MainWindow::paint_picture(const QString& path) {
    parts_->pictures.paint_picture(path);
}

void MainWindow::trace_picture(const QString& path) {
    parts_->tracing.trace_picture(path);
}

void MainWindow::save_painting(const QString& path) {
    parts_->files.save_painting(path);
}

void MainWindow::recover_painting(const std::filesystem::path& journal) {
    parts_->files.recover_painting(journal);
}

void MainWindow::offer_recovery() {
    parts_->files.offer_recovery();
}

void MainWindow::show_start_page() {
    parts_->start.show_page();
}

void MainWindow::welcome() {
    parts_->start.welcome();
}

void MainWindow::replay(const document::Recording& recording) {
    parts_->transform.end();
    parts_->files.replay(recording);
}

commands::Exporter& MainWindow::exporter() {
    return parts_->exporting.exporter();
}

commands::ProjectSaver& MainWindow::project_saver() {
    return parts_->files.saver();
}

void MainWindow::export_painting(const tools::ExportSettings& settings,
                                 const std::filesystem::path& path) {
    parts_->exporting.start(settings, path);
}

void MainWindow::use_light(const QString& name_or_path) {
    parts_->light.use(name_or_path);
}

void MainWindow::use_space(pigment::WorkingSpace space) {
    parts_->light.use_space(space);
}

TankMode& MainWindow::tank() {
    return parts_->tank;
}

TeaMode& MainWindow::tea() {
    return parts_->tea;
}

void MainWindow::measure(std::shared_ptr<session::FrameTimes> times) {
    studio_.measure(std::move(times));
}

void MainWindow::open_palette(const QString& path) {
    parts_->paints.open_palette(path);
}

}  // namespace pastoso::main
