#include "main/canvas/selection_commands.hpp"

#include "panels/parts/status_readings.hpp"
#include "panels/pen/brush_panel.hpp"
#include "tools/selecting.hpp"

#include <utility>

#include <QAction>
#include <QMainWindow>
#include <QStatusBar>

namespace pastoso::main {

using commands::Command;

namespace {

QString outside_words() {
    return SelectionCommands::tr("Outside the selection: nothing is painted there.");
}

}  // namespace

SelectionCommands::SelectionCommands(Studio& studio, panels::BrushPanel* brushes,
                                     panels::StatusReadings* readings)
    : studio_(studio), readings_(readings) {
    const auto draw = [this](interactions::AreaForm form) {
        return [this, form](bool on) { draw_areas(on ? std::optional(form) : std::nullopt); };
    };
    studio_.commands().on(Command::SelectRectangle, draw(interactions::AreaForm::Rectangle));
    studio_.commands().on(Command::SelectLasso, draw(interactions::AreaForm::Lasso));
    studio_.commands().on(Command::SelectEverything,
                          [this](bool) { studio_.easel().select(document::SelectAll{}); });
    studio_.commands().on(Command::InvertSelection,
                          [this](bool) { studio_.easel().select(document::InvertSelection{}); });
    studio_.commands().on(Command::ShowOutline,
                          [this](bool shown) { studio_.canvas().show_outline(shown); });
    studio_.commands().action(Command::ShowOutline)->setChecked(true);
    connect(brushes, &panels::BrushPanel::brush_taken, this, [this] { draw_areas(std::nullopt); });
    connect(&studio_.on_canvas().areas, &interactions::Areas::left, this,
            [this] { draw_areas(std::nullopt); });
    connect(&studio_.on_canvas().areas, &interactions::Areas::begun, this,
            &SelectionCommands::tell_combination);
    connect(&studio_.on_canvas().areas, &interactions::Areas::cancelled, this,
            [this] { studio_.report(tr("Nothing was selected. Esc again goes back to painting.")); });
    connect(&studio_.on_canvas().areas, &interactions::Areas::drawn, this,
            [this](const document::SelectArea& area) {
                studio_.easel().select(area);
                studio_.report(
                    tr("Tools keep to the outline. Esc, or taking a tool, goes back to painting."));
            });
    connect(&studio_.on_canvas().areas, &interactions::Areas::clicked, this,
            [this](grid::Combination how) {
                const bool ends = how == grid::Combination::Replace && shown_ != nullptr;
                if (ends) studio_.easel().select(document::SelectAll{});
            });
    connect(&studio_.on_canvas().paint, &interactions::Paint::stroke_begun, this,
            &SelectionCommands::warn_outside);
    connect(&studio_.canvas(), &view::CanvasView::pointer_moved, this, [this](const QPointF& canvas_mm) {
        if (studio_.easel().painting() &&
            studio_.window().statusBar()->currentMessage() == outside_words())
            warn_outside(canvas_mm);
    });
    connect(&studio_, &Studio::published, this, [this](const auto& painting) { show(*painting); });
    show_reading();
}

/// Nothing: the brush paints again.
void SelectionCommands::draw_areas(std::optional<interactions::AreaForm> form) {
    if (form == form_) return;
    if (form) Q_EMIT drawing_begins();
    form_ = form;
    studio_.on_canvas().areas.draw_next(form);
    studio_.commands()
        .action(Command::SelectRectangle)
        ->setChecked(form == interactions::AreaForm::Rectangle);
    studio_.commands().action(Command::SelectLasso)->setChecked(form == interactions::AreaForm::Lasso);
    if (form)
        studio_.report(
            tr("Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is "
               "in both; a click ends the selection."));
    else
        studio_.report(tr("The brush paints again."));
    show_reading();
}

void SelectionCommands::tell_combination(grid::Combination how) {
    switch (how) {
        case grid::Combination::Replace:
            return studio_.report(tr("Selects what is inside."));
        case grid::Combination::Add:
            return studio_.report(tr("Adds what is inside to the selection."));
        case grid::Combination::Subtract:
            return studio_.report(tr("Takes what is inside out of the selection."));
        case grid::Combination::Intersect:
            return studio_.report(tr("Keeps what is inside and was selected before."));
    }
}

/// Said of a stroke for as long as it touches nothing that is selected.
void SelectionCommands::warn_outside(const QPointF& canvas_mm) {
    if (studio_.easel().brush_is_lent())
        return studio_.report(tr("A recording is being played; the brush is yours when it has ended."));
    const tools::Hand& hand = studio_.easel().hand();
    const bool touches =
        tools::touches_selection(*studio_.session().snapshot(), hand.symmetry, canvas_mm.x(),
                                 canvas_mm.y(), 0.5 * hand.brush_width_mm);
    if (!touches)
        studio_.report(outside_words());
    else if (studio_.window().statusBar()->currentMessage() == outside_words())
        studio_.window().statusBar()->clearMessage();
}

void SelectionCommands::show(const document::Snapshot& painting) {
    if (painting.selection == shown_) return;
    shown_ = painting.selection;
    if (shown_ == nullptr) studio_.report(tr("Nothing is selected: tools work on all of the canvas."));
    show_reading();
}

void SelectionCommands::show_reading() {
    const bool any = shown_ != nullptr;
    for (const Command command :
         {Command::SelectEverything, Command::InvertSelection, Command::CropToSelection})
        studio_.commands().action(command)->setEnabled(any);
    QString drawing;
    if (form_) drawing = form_ == interactions::AreaForm::Lasso ? tr("lasso") : tr("rectangle");
    readings_->show_selection(drawing,
                              any ? std::optional(tools::selected_share(shown_)) : std::nullopt);
}

}  // namespace pastoso::main
