#include "main/main_window.hpp"

#include "brush/preset.hpp"
#include "document/well.hpp"
#include "io/canvas_support.hpp"
#include "main/view_commands.hpp"
#include "panels/brush_panel.hpp"
#include "panels/colour_panel.hpp"
#include "panels/curves_panel.hpp"
#include "panels/easel_panel.hpp"
#include "panels/load_panel.hpp"
#include "panels/paint_panel.hpp"
#include "panels/status_readings.hpp"
#include "pigment/user_pigments.hpp"

#include <atomic>
#include <utility>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QGuiApplication>
#include <QStatusBar>

namespace pastoso::main {
namespace {

view::TipShape tip_in_hand(const tools::Hand& hand) {
    const brush::Preset preset = brush::resized(tools::preset_in_hand(hand), hand.brush_width_mm);
    return {.width_mm = preset.tip.width_mm,
            .thickness_mm = preset.tip.thickness_mm,
            .angular = preset.tip.shape != brush::TipShape::Round};
}

}  // namespace

MainWindow::MainWindow(const document::CanvasSettings& canvas, bool keeps_journal)
    : keeps_journal_(keeps_journal),
      commands_(this),
      easel_(std::make_unique<tools::Easel>(
          tools::Hand{}, [this](document::Action action) { session_->post(std::move(action)); },
          [this] { session_->note_hand(); })),
      canvas_(new view::CanvasView(easel_.get())),
      well_(new view::CanvasView(easel_.get(), document::Surface::Well)) {
    start_session(canvas);
    lay_out();
    view_commands_ = new ViewCommands(this, commands_, {canvas_, well_, readings_, stand_});
    connect_canvas();
    connect_panels();
    connect_docks();
    connect_well();
    connect_commands();
    connect_file_commands();
    connect_brush_commands();
    connect_guide_commands();
    connect_layers();
    connect_selection();
    connect_tracing();
    connect_canvas_size();
    connect_transform();
    connect_light_commands();
    connect_project_commands();
    connect_picture_commands();
    connect_export();
    read_brushes();
    recall();
    easel_->set_up();
    show_hand();
    show_published();
    for (const std::string& fault : pigment::user_pigments().faults)
        report(QString::fromStdString(fault));
}

MainWindow::~MainWindow() {
    // The views are destroyed after the members here, and show nothing of them any more.
    canvas_->disconnect(this);
    well_panel_->disconnect(this);
}

void MainWindow::start_session(const document::CanvasSettings& canvas) {
    auto pool = std::make_unique<core::ThreadPool>();
    auto painting = io::make_painting(canvas, *pool);
    start_session(std::move(pool), std::move(painting), {}, {.canvas = canvas});
}

void MainWindow::start_session(std::unique_ptr<core::ThreadPool> pool,
                               std::unique_ptr<document::Painting> painting, document::Recording past,
                               journal::Beginning beginning) {
    beginning.canvas = painting->settings();
    beginning.tick = painting->tick();
    auto journal = new_journal(beginning);
    end_transform();
    if (session_) session_->discard_journal();
    // One refresh at a time waits in the event queue, however often the session publishes.
    auto pending = std::make_shared<std::atomic<bool>>(false);
    auto notify = [this, pending] {
        if (pending->exchange(true)) return;
        QMetaObject::invokeMethod(
            this,
            [this, pending] {
                pending->store(false);
                show_published();
            },
            Qt::QueuedConnection);
    };
    session_ = std::make_unique<session::PaintSession>(
        std::move(pool), std::move(painting), std::move(notify), std::move(past),
        commands_.action(commands::Command::Pause)->isChecked(), std::move(journal));
    set_undo_memory(undo_memory_MiB_);
    journal_events_saved_.reset();
    path_.clear();
    saved_changes_ = 0;
    shown_bare_.reset();
    exported_.reset();
    show_export_commands();
    show_title();
    forget_layer_pictures();
}

void MainWindow::new_canvas(const document::CanvasSettings& canvas) {
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    try {
        start_session(canvas);
    } catch (...) {
        QGuiApplication::restoreOverrideCursor();
        throw;
    }
    QGuiApplication::restoreOverrideCursor();
    easel_->set_up();
    const brush::Symmetry& symmetry = easel_->hand().symmetry;
    if (symmetry.mirror || symmetry.count > 1) {
        brush::Symmetry centred = symmetry;
        centred.centre_x_mm = 0.5 * canvas.width_mm;
        centred.centre_y_mm = 0.5 * canvas.height_mm;
        set_symmetry(centred);
    }
    show_published();
}

void MainWindow::replay(const document::Recording& recording) {
    end_transform();
    if (!(recording.canvas == session_->canvas())) new_canvas(recording.canvas);
    session_->play(recording.events);
    easel_->lend_brush(true);
    easel_->adopt(tools::hand_after(easel_->hand(), recording.events));
    show_hand();
}

void MainWindow::show_published() {
    const auto snapshot = session_->snapshot();
    canvas_->show_snapshot(snapshot, follow_cloth(snapshot->bare));
    readings_->show_canvas(snapshot->bare->settings);
    show_layers(*snapshot);
    show_selection(*snapshot);
    show_tracing(*snapshot);
    show_well(*snapshot);
    load_->show_load(snapshot->brush_load);
    const session::Status status = session_->status();
    readings_->show_status(status);
    show_enabled(status);
    follow_transform(*snapshot, status);
    easel_->lend_brush(status.replaying);
    setWindowModified(status.changes != saved_changes_);
    for (const std::string& error : session_->take_errors())
        report_refusal(QString::fromStdString(error));
}

/// The well's view is left alone while nothing in the well changes.
void MainWindow::show_well(const document::Snapshot& painting) {
    static const film::FilmState bare = document::bare_well();
    auto well = std::make_shared<const document::Snapshot>(painting.well.value_or(bare), painting.ground,
                                                           painting.tick);
    if (shown_well_ != nullptr && view::changed_tiles(shown_well_.get(), *well).empty()) return;
    shown_well_ = std::move(well);
    well_->show_snapshot(shown_well_);
}

void MainWindow::show_enabled(const session::Status& status) {
    commands_.action(commands::Command::Undo)
        ->setEnabled(status.can_undo || status.stroke_in_progress || transforming_);
    commands_.action(commands::Command::Redo)->setEnabled(status.can_redo);
}

void MainWindow::show_hand() {
    const tools::Hand& hand = easel_->hand();
    brushes_->show_brush(QString::fromStdString(hand.brush), hand.brush_width_mm);
    show_paint(hand.paint);
    stand_->show_tilt(hand.tilt.tilt_deg, hand.tilt.direction_deg);
    stand_->show_drying(hand.air.speed);
    brushes_->show_stabiliser(hand.stabiliser);
    load_->show_hand(hand);
    curves_->show_preset(tools::preset_in_hand(hand), kept_brush());
    show_guides();
    medium_->setCurrentText(QString::fromStdString(hand.medium));
    commands_.action(commands::Command::ReloadEachStroke)->setChecked(hand.reload_each_stroke);
    commands_.action(commands::Command::TurnWithStroke)->setChecked(hand.turn_with_stroke);
    const bool dips = tools::preset_in_hand(hand).dips;
    for (const auto command : {commands::Command::ReloadBrush, commands::Command::TopUpBrush})
        commands_.action(command)->setEnabled(dips);
    for (const auto command : {commands::Command::RenameBrush, commands::Command::DeleteBrush})
        commands_.action(command)->setEnabled(own_brush_in_hand());
    for (view::CanvasView* view : {canvas_, well_})
        view->set_tip(tip_in_hand(hand));
}

void MainWindow::choose_paint(const document::PaintRecipe& paint) {
    easel_->choose_paint(paint);
    show_hand();
}

void MainWindow::show_paint(const document::PaintRecipe& paint) {
    colours_->show_paint(paint);
    const auto& mix = paint.ingredients;
    paints_->show_paint(mix.empty() ? QString() : QString::fromStdString(mix.front().pigment));
}

void MainWindow::report(const QString& sentence) {
    constexpr int kReadingTime_ms = 12000;
    statusBar()->showMessage(sentence, kReadingTime_ms);
}

/// Sentences of the engine begin small, since many stand behind the name of a file.
void MainWindow::report_refusal(QString sentence) {
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    report(sentence);
}

}  // namespace pastoso::main
