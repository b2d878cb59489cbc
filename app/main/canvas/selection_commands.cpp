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

using interactions::AreaForm;
using interactions::WandReach;

/// What a press on the canvas does while the command is on.
struct WayToSelect {
    Command command;
    std::optional<AreaForm> form;
    std::optional<WandReach> reach;
    const char* name;  ///< in the status bar
};

constexpr WayToSelect kWays[] = {
    {Command::SelectRectangle,
     AreaForm::Rectangle,
     {},
     QT_TRANSLATE_NOOP("pastoso::main::SelectionCommands", "rectangle")},
    {Command::SelectEllipse,
     AreaForm::Ellipse,
     {},
     QT_TRANSLATE_NOOP("pastoso::main::SelectionCommands", "ellipse")},
    {Command::SelectPolygon,
     AreaForm::Polygon,
     {},
     QT_TRANSLATE_NOOP("pastoso::main::SelectionCommands", "polygon")},
    {Command::SelectLasso,
     AreaForm::Lasso,
     {},
     QT_TRANSLATE_NOOP("pastoso::main::SelectionCommands", "lasso")},
    {Command::SelectContiguous,
     {},
     WandReach::Connected,
     QT_TRANSLATE_NOOP("pastoso::main::SelectionCommands", "contiguous colour")},
    {Command::SelectSimilar,
     {},
     WandReach::Everywhere,
     QT_TRANSLATE_NOOP("pastoso::main::SelectionCommands", "similar colour")},
};

const WayToSelect* way_of(std::optional<Command> command) {
    for (const WayToSelect& way : kWays)
        if (way.command == command) return &way;
    return nullptr;
}

QString words_of(const WayToSelect& way) {
    if (way.reach)
        return SelectionCommands::tr(
            "Click the colour that tools shall keep to; drag to the right for more, to the left for "
            "less of it. Shift adds, Alt takes away, both keep what is in both.");
    if (way.form == AreaForm::Polygon)
        return SelectionCommands::tr(
            "Click the corners of what tools shall keep to. Enter or a double click closes it, "
            "Backspace takes the last corner back, Esc gives it up.");
    return SelectionCommands::tr(
        "Drag around what tools shall keep to. Shift adds, Alt takes away, both keep what is "
        "in both; a click ends the selection.");
}

QString outside_words() {
    return SelectionCommands::tr("Outside the selection: nothing is painted there.");
}

}  // namespace

SelectionCommands::SelectionCommands(Studio& studio, panels::BrushPanel* brushes,
                                     panels::StatusReadings* readings)
    : studio_(studio), readings_(readings) {
    for (const WayToSelect& way : kWays)
        studio_.commands().on(way.command, [this, command = way.command](bool on) {
            select_by(on ? std::optional(command) : std::nullopt);
        });
    studio_.commands().on(Command::SelectEverything,
                          [this](bool) { studio_.easel().select(document::SelectAll{}); });
    studio_.commands().on(Command::InvertSelection,
                          [this](bool) { studio_.easel().select(document::InvertSelection{}); });
    studio_.commands().on(Command::SelectPaint,
                          [this](bool) { studio_.easel().select(document::SelectPaint{}); });
    studio_.commands().on(Command::ShowOutline,
                          [this](bool shown) { studio_.canvas().show_outline(shown); });
    studio_.commands().action(Command::ShowOutline)->setChecked(true);
    connect(brushes, &panels::BrushPanel::brush_taken, this, &SelectionCommands::go_back_to_painting);
    listen_to_areas();
    listen_to_wand();
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

void SelectionCommands::listen_to_areas() {
    const interactions::Areas* areas = &studio_.on_canvas().areas;
    connect(areas, &interactions::Areas::left, this, &SelectionCommands::go_back_to_painting);
    connect(areas, &interactions::Areas::begun, this, &SelectionCommands::tell_combination);
    connect(areas, &interactions::Areas::cancelled, this, &SelectionCommands::tell_cancelled);
    connect(areas, &interactions::Areas::drawn, this, [this](const document::SelectArea& area) {
        studio_.easel().select(area);
        studio_.report(tr("Tools keep to the outline. Esc, or taking a tool, goes back to painting."));
    });
    connect(areas, &interactions::Areas::clicked, this, [this](grid::Combination how) {
        const bool ends = how == grid::Combination::Replace && shown_ != nullptr;
        if (ends) studio_.easel().select(document::SelectAll{});
    });
}

void SelectionCommands::listen_to_wand() {
    const interactions::ColourWand* wand = &studio_.on_canvas().wand;
    connect(wand, &interactions::ColourWand::left, this, &SelectionCommands::go_back_to_painting);
    connect(wand, &interactions::ColourWand::cancelled, this, &SelectionCommands::tell_cancelled);
    connect(wand, &interactions::ColourWand::pulled, this,
            [this](const document::SelectSimilarColour& colour) {
                studio_.report(tr("Colours that differ by up to %1. Drag to the right for more, to the "
                                  "left for less.")
                                   .arg(colour.difference));
            });
    connect(
        wand, &interactions::ColourWand::chosen, this,
        [this](const document::SelectSimilarColour& colour) {
            studio_.easel().select(colour);
            studio_.report(tr("Tools keep to colours that differ by up to %1 from the one there. Esc, "
                              "or taking a tool, goes back to painting.")
                               .arg(colour.difference));
        });
}

/// Nothing: the brush paints again.
void SelectionCommands::select_by(std::optional<Command> way) {
    if (way == way_) return;
    if (way) Q_EMIT selecting_begins();
    way_ = way;
    for (const WayToSelect& one : kWays)
        studio_.commands().action(one.command)->setChecked(one.command == way);
    const WayToSelect* chosen = way_of(way);
    studio_.on_canvas().areas.draw_next(chosen ? chosen->form : std::nullopt);
    studio_.on_canvas().wand.take(chosen ? chosen->reach : std::nullopt);
    studio_.report(chosen ? words_of(*chosen) : tr("The brush paints again."));
    show_reading();
}

void SelectionCommands::tell_cancelled() {
    studio_.report(tr("Nothing was selected. Esc again goes back to painting."));
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
         {Command::SelectEverything, Command::InvertSelection, Command::CropToSelection,
          Command::GrowSelection, Command::ShrinkSelection, Command::BorderSelection,
          Command::FeatherSelection})
        studio_.commands().action(command)->setEnabled(any);
    const WayToSelect* way = way_of(way_);
    const QString drawing = way ? tr(way->name) : QString();
    readings_->show_selection(drawing,
                              any ? std::optional(tools::selected_share(shown_)) : std::nullopt);
}

}  // namespace pastoso::main
