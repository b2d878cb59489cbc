// What MainWindow does when something is chosen, moved or asked for.

#include "core/error.hpp"
#include "dialogs/new_canvas_dialog.hpp"
#include "main/main_window.hpp"
#include "panels/brush_panel.hpp"
#include "panels/easel_panel.hpp"
#include "panels/paint_panel.hpp"
#include "panels/status_readings.hpp"

#include <utility>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QMessageBox>
#include <QStatusBar>

namespace pastoso::main {

using commands::Command;

void MainWindow::connect_panels() {
    connect(brushes_, &panels::BrushPanel::brush_taken, this, &MainWindow::take_brush);
    connect(brushes_, &panels::BrushPanel::faulty_clicked, this, [this](const QString& fault) {
        report(fault);
        show_hand();
    });
    connect(brushes_, &panels::BrushPanel::width_chosen, this, [this](double width_mm) {
        easel_->set_brush_width(width_mm);
        show_hand();
    });
    connect(brushes_, &panels::BrushPanel::stabiliser_chosen, this,
            [this](const brush::Stabiliser& stabiliser) { easel_->set_stabiliser(stabiliser); });
    connect(paints_, &panels::PaintPanel::paint_chosen, this, [this](const QString& pigment) {
        document::PaintRecipe paint;
        if (!pigment.isEmpty()) paint.ingredients = {{pigment.toStdString(), 1.0}};
        choose_paint(paint);
    });
    connect(medium_, &QComboBox::activated, this,
            [this] { easel_->use_medium(medium_->currentText().toStdString()); });
    connect(stand_, &panels::EaselPanel::tilted, this,
            [this](double tilt_deg, double direction_deg) { easel_->tilt(tilt_deg, direction_deg); });
    connect(stand_, &panels::EaselPanel::drying_changed, this,
            [this](double speed) { easel_->set_drying_speed(speed); });
    connect(stand_, &panels::EaselPanel::illuminant_chosen, this, &MainWindow::use_light);
    connect(stand_, &panels::EaselPanel::illuminant_file_wanted, this, &MainWindow::ask_light);
}

/// The first time it is given room to mix in; after that it is as large as the painter leaves it.
void MainWindow::open_well(bool open) {
    well_panel_->setVisible(open);
    if (!open || std::exchange(well_sized_, true)) return;
    constexpr int kRoomy = 320;
    resizeDocks({well_panel_}, {kRoomy}, Qt::Vertical);
}

void MainWindow::connect_well() {
    connect(well_panel_, &QDockWidget::visibilityChanged, this,
            [this] { commands_.action(Command::MixingWell)->setChecked(!well_panel_->isHidden()); });
    commands_.on(Command::MixingWell, [this](bool open) { open_well(open); });
    commands_.on(Command::SqueezePaint, [this](bool) {
        const auto place_mm = well_->pointer_mm();
        if (place_mm)
            easel_->squeeze(place_mm->x, place_mm->y);
        else
            easel_->squeeze_next();
        open_well(true);
    });
    commands_.on(Command::CleanWell, [this](bool) { easel_->clean_well(); });
}

void MainWindow::connect_canvas() {
    connect(canvas_, &view::CanvasView::pointer_moved, this,
            [this](const QPointF& canvas_mm) { readings_->show_pointer(canvas_mm); });
    connect(canvas_, &view::CanvasView::pointer_left, this,
            [this] { readings_->show_pointer(std::nullopt); });
    connect(canvas_, &view::CanvasView::guide_dragged, this, &MainWindow::move_guide);
    connect(canvas_, &view::CanvasView::picked, this, [this](const QPointF& place_mm, tools::Pick pick) {
        pick_from(document::Surface::Canvas, place_mm, pick);
    });
    connect(well_, &view::CanvasView::picked, this, [this](const QPointF& place_mm, tools::Pick pick) {
        pick_from(document::Surface::Well, place_mm, pick);
    });
}

void MainWindow::connect_commands() {
    // A frame is what was done last.
    commands_.on(Command::Undo, [this](bool) {
        if (!give_up_transform()) easel_->undo();
    });
    commands_.on(Command::Redo, [this](bool) {
        end_transform();
        easel_->redo();
    });
    commands_.on(Command::ReloadBrush, [this](bool) { easel_->reload(); });
    commands_.on(Command::TopUpBrush, [this](bool) { easel_->dip(); });
    commands_.on(Command::BlotBrush, [this](bool) { easel_->blot(); });
    commands_.on(Command::CleanBrush, [this](bool) { easel_->clean(); });
    commands_.on(Command::SwapPaints, [this](bool) {
        easel_->swap_paints();
        show_hand();
    });
    const auto pick_next = [this](tools::Pick pick) {
        return
            [this, pick](bool picks) { pick_at_next_click(picks ? std::optional(pick) : std::nullopt); };
    };
    commands_.on(Command::PickPaint, pick_next(tools::Pick::Paint));
    commands_.on(Command::PickColour, pick_next(tools::Pick::Seen));
    commands_.on(Command::DryNow, [this](bool) { easel_->dry_now(); });
    commands_.on(Command::ReloadEachStroke,
                 [this](bool reload) { easel_->set_reload_each_stroke(reload); });
    commands_.on(Command::TurnWithStroke, [this](bool turn) { easel_->set_turn_with_stroke(turn); });
    commands_.on(Command::NextBrush, [this](bool) { brushes_->take_next(1); });
    commands_.on(Command::PreviousBrush, [this](bool) { brushes_->take_next(-1); });
    const auto step_width = [this](int steps) {
        easel_->set_brush_width(tools::stepped_brush_width_mm(easel_->hand().brush_width_mm, steps));
        show_hand();
    };
    commands_.on(Command::SmallerBrush, [step_width](bool) { step_width(-1); });
    commands_.on(Command::LargerBrush, [step_width](bool) { step_width(1); });
    commands_.on(Command::Pause, [this](bool paused) {
        session_->set_paused(paused);
        readings_->show_status(session_->status());
    });
    constexpr double kZoomStep = 1.25;
    commands_.on(Command::FitCanvas, [this](bool) { canvas_->fit(); });
    commands_.on(Command::ActualPixels, [this](bool) { canvas_->show_actual_pixels(); });
    commands_.on(Command::ZoomIn, [this](bool) { canvas_->zoom_about_centre(kZoomStep); });
    commands_.on(Command::ZoomOut, [this](bool) { canvas_->zoom_about_centre(1.0 / kZoomStep); });
}

void MainWindow::connect_file_commands() {
    commands_.on(Command::NewCanvas, [this](bool) { ask_new_canvas(); });
    commands_.on(Command::Quit, [this](bool) { close(); });
}

void MainWindow::ask_new_canvas() {
    dialogs::NewCanvasDialog dialog(session_->canvas(), this);
    if (dialog.exec() != QDialog::Accepted || !may_discard()) return;
    try {
        new_canvas(dialog.settings());
    } catch (const core::InputError& error) {
        QMessageBox::warning(this, tr("New canvas"), QString::fromUtf8(error.what()));
    }
}

}  // namespace pastoso::main
