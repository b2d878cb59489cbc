// MainWindow's selections: outlines drawn on the canvas, ranges of height and wetness, and what is told
// of them.

#include "dialogs/select_range_dialog.hpp"
#include "main/main_window.hpp"
#include "panels/brush_panel.hpp"
#include "panels/status_readings.hpp"
#include "tools/selecting.hpp"

#include <cmath>
#include <utility>

#include <QAction>
#include <QStatusBar>

namespace pastoso::main {

using commands::Command;

namespace {

/// So often an open dialog looks at paint that moves.
constexpr int kLook_ms = 400;

constexpr int kMargin_px = 16;

/// Thinner paint is no more than a stain.
constexpr double kLeastWet_mm = 0.005;

/// Paint that stands higher than most, or all that is wet. Of a bare canvas, what thick paint will be.
dialogs::SelectedRange first_range(bool wetness, const tools::PaintDepths& depths) {
    constexpr double kFine_mm = 0.01;
    if (depths.most_mm == 0.0) return {.least_mm = wetness ? kLeastWet_mm : 0.5, .most_mm = 10.0};
    return {.least_mm = wetness ? kLeastWet_mm : kFine_mm * std::round(depths.mean_mm / kFine_mm),
            .most_mm = kFine_mm * std::ceil(depths.most_mm / kFine_mm)};
}

QString outside_words() {
    return MainWindow::tr("Outside the selection: nothing is painted there.");
}

/// Whether the same range holds the same cells of both.
bool looks_alike(const document::Snapshot& a, const document::Snapshot& b) {
    return a.film.shape == b.film.shape && a.selection == b.selection && a.layers == b.layers &&
           view::changed_tiles(&a, b).empty();
}

template <class Select>
Select range_action(const dialogs::SelectedRange& range) {
    return {range.least_mm, range.most_mm, range.how};
}

}  // namespace

void MainWindow::connect_selection() {
    const auto draw = [this](view::AreaForm form) {
        return [this, form](bool on) { draw_areas(on ? std::optional(form) : std::nullopt); };
    };
    commands_.on(Command::SelectRectangle, draw(view::AreaForm::Rectangle));
    commands_.on(Command::SelectLasso, draw(view::AreaForm::Lasso));
    commands_.on(Command::SelectEverything, [this](bool) { easel_->select(document::SelectAll{}); });
    commands_.on(Command::InvertSelection,
                 [this](bool) { easel_->select(document::InvertSelection{}); });
    commands_.on(Command::SelectHeight, [this](bool) { ask_range(false); });
    commands_.on(Command::SelectWetness, [this](bool) { ask_range(true); });
    commands_.on(Command::ShowOutline, [this](bool shown) { canvas_->show_outline(shown); });
    commands_.action(Command::ShowOutline)->setChecked(true);
    connect(brushes_, &panels::BrushPanel::brush_taken, this, [this] { draw_areas(std::nullopt); });
    connect(canvas_, &view::CanvasView::areas_left, this, [this] { draw_areas(std::nullopt); });
    connect(canvas_, &view::CanvasView::area_begun, this, &MainWindow::tell_combination);
    connect(canvas_, &view::CanvasView::area_given_up, this,
            [this] { report(tr("Nothing was selected. Esc again goes back to painting.")); });
    connect(canvas_, &view::CanvasView::area_drawn, this, [this](const document::SelectArea& area) {
        easel_->select(area);
        report(tr("Tools keep to the outline. Esc, or taking a tool, goes back to painting."));
    });
    connect(canvas_, &view::CanvasView::area_clicked, this, [this](grid::Combination how) {
        const bool ends = how == grid::Combination::Replace && shown_selection_ != nullptr;
        if (ends) easel_->select(document::SelectAll{});
    });
    connect(canvas_, &view::CanvasView::stroke_begun, this, &MainWindow::warn_outside);
    connect(canvas_, &view::CanvasView::pointer_moved, this, [this](const QPointF& canvas_mm) {
        if (easel_->painting() && statusBar()->currentMessage() == outside_words())
            warn_outside(canvas_mm);
    });
    show_selection_reading();
}

/// Nothing: the brush paints again.
void MainWindow::draw_areas(std::optional<view::AreaForm> form) {
    if (form == area_form_) return;
    if (form) end_transform();
    area_form_ = form;
    canvas_->draw_areas(form);
    commands_.action(Command::SelectRectangle)->setChecked(form == view::AreaForm::Rectangle);
    commands_.action(Command::SelectLasso)->setChecked(form == view::AreaForm::Lasso);
    if (form)
        report(
            tr("Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is "
               "in both; a click ends the selection."));
    else
        report(tr("The brush paints again."));
    show_selection_reading();
}

void MainWindow::tell_combination(grid::Combination how) {
    switch (how) {
        case grid::Combination::Replace:
            return report(tr("Selects what is inside."));
        case grid::Combination::Add:
            return report(tr("Adds what is inside to the selection."));
        case grid::Combination::Subtract:
            return report(tr("Takes what is inside out of the selection."));
        case grid::Combination::Intersect:
            return report(tr("Keeps what is inside and was selected before."));
    }
}

/// Said of a stroke for as long as it touches nothing that is selected.
void MainWindow::warn_outside(const QPointF& canvas_mm) {
    if (easel_->brush_is_lent())
        return report(tr("A recording is being played; the brush is yours when it has ended."));
    const tools::Hand& hand = easel_->hand();
    const bool touches = tools::touches_selection(*session_->snapshot(), hand.symmetry, canvas_mm.x(),
                                                  canvas_mm.y(), 0.5 * hand.brush_width_mm);
    if (!touches)
        report(outside_words());
    else if (statusBar()->currentMessage() == outside_words())
        statusBar()->clearMessage();
}

// ---- by height and by wetness

void MainWindow::ask_range(bool wetness) {
    delete range_;
    const auto painting = session_->snapshot();
    const tools::PaintDepths depths =
        wetness ? tools::wetness_on(*painting) : tools::heights_on(*painting);
    const QString words =
        wetness ? tr("Wet paint of this layer is up to %1 mm thick, %2 mm on average.")
                : tr("Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.");
    range_ = new dialogs::SelectRangeDialog(
        wetness ? tr("Select by wetness") : tr("Select by height"),
        words.arg(depths.most_mm, 0, 'f', 2).arg(depths.mean_mm, 0, 'f', 2),
        first_range(wetness, depths), this);
    range_->setAttribute(Qt::WA_DeleteOnClose);
    connect(range_, &dialogs::SelectRangeDialog::changed, this, [=, this] { preview_range(wetness); });
    connect(range_, &QDialog::accepted, this, [=, this] {
        const dialogs::SelectedRange range = range_->chosen();
        easel_->select(wetness ? document::Action(range_action<document::SelectByWetness>(range))
                               : document::Action(range_action<document::SelectByHeight>(range)));
    });
    connect(range_, &QDialog::finished, this, [this] { canvas_->preview_selection(std::nullopt); });
    auto* looks = new QTimer(range_);
    connect(looks, &QTimer::timeout, this, [=, this, seen = painting]() mutable {
        const auto now = session_->snapshot();
        if (looks_alike(*std::exchange(seen, now), *now)) return;
        preview_range(wetness);
    });
    looks->start(kLook_ms);
    // In a corner, where it hides little of what it outlines.
    const int corner_y = canvas_->height() - range_->sizeHint().height() - kMargin_px;
    range_->move(canvas_->mapToGlobal(QPoint(kMargin_px, corner_y)));
    range_->show();
    preview_range(wetness);
}

void MainWindow::preview_range(bool wetness) {
    const dialogs::SelectedRange range = range_->chosen();
    const auto painting = session_->snapshot();
    const document::Selection selection =
        wetness ? tools::selection_after(*painting, range_action<document::SelectByWetness>(range))
                : tools::selection_after(*painting, range_action<document::SelectByHeight>(range));
    canvas_->preview_selection(selection);
    range_->show_outcome(tools::selected_share(selection), selection == nullptr);
}

// ---- what is told

void MainWindow::show_selection(const document::Snapshot& painting) {
    if (painting.selection == shown_selection_) return;
    shown_selection_ = painting.selection;
    if (shown_selection_ == nullptr) report(tr("Nothing is selected: tools work on all of the canvas."));
    show_selection_reading();
}

void MainWindow::show_selection_reading() {
    const bool any = shown_selection_ != nullptr;
    for (const Command command :
         {Command::SelectEverything, Command::InvertSelection, Command::CropToSelection})
        commands_.action(command)->setEnabled(any);
    QString drawing;
    if (area_form_) drawing = area_form_ == view::AreaForm::Lasso ? tr("lasso") : tr("rectangle");
    readings_->show_selection(
        drawing, any ? std::optional(tools::selected_share(shown_selection_)) : std::nullopt);
}

}  // namespace pastoso::main
