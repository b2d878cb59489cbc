// MainWindow's eyedropper: paint, or the colour that it has, from canvas and well.

#include "document/well.hpp"
#include "main/main_window.hpp"
#include "tools/canvas_colour.hpp"
#include "tools/colour_paint.hpp"

#include <QAction>

namespace pastoso::main {

using commands::Command;

namespace {

document::Snapshot snapshot_of(const document::Snapshot& painting, document::Surface surface) {
    if (surface == document::Surface::Canvas) return painting;
    return {painting.well.value_or(document::bare_well()), painting.ground, painting.tick};
}

}  // namespace

void MainWindow::pick_at_next_click(std::optional<tools::Pick> pick) {
    commands_.action(Command::PickPaint)->setChecked(pick == tools::Pick::Paint);
    commands_.action(Command::PickColour)->setChecked(pick == tools::Pick::Seen);
    for (view::CanvasView* view : {canvas_, well_})
        view->pick_next(pick);
}

/// Where no paint lies, its colour is all there is to pick.
void MainWindow::pick_from(document::Surface surface, const QPointF& place_mm, tools::Pick pick) {
    pick_at_next_click(std::nullopt);
    const document::Snapshot there = snapshot_of(*session_->snapshot(), surface);
    const auto paint = pick == tools::Pick::Paint ? tools::paint_at(there.film, session_->paints_used(),
                                                                    place_mm.x(), place_mm.y())
                                                  : std::nullopt;
    if (paint)
        pick_paint(*paint);
    else
        pick_colour(there, place_mm);
}

void MainWindow::pick_paint(const tools::PickedPaint& paint) {
    choose_paint(paint.recipe);
    const QString words = paint.layer == film::PaintLayer::Wet ? tr("Picked up wet paint: %1")
                                                               : tr("Picked up dry paint: %1");
    report(words.arg(QString::fromStdString(tools::pigment_shares(paint.recipe))));
}

void MainWindow::pick_colour(const document::Snapshot& there, const QPointF& place_mm) {
    const auto colour = tools::colour_at(there, place_mm.x(), place_mm.y());
    if (!colour) return report(tr("There is no colour to pick beside the canvas."));
    choose_paint(tools::colour_paint(*colour));
    report(tr("Picked the colour seen: %1").arg(QString::fromStdString(pigment::hex_colour(*colour))));
}

}  // namespace pastoso::main
