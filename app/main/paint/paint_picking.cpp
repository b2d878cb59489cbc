#include "main/paint/paint_picking.hpp"

#include "document/actions/actions.hpp"
#include "document/well.hpp"
#include "panels/paint/paint_words.hpp"
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

PaintPicking::PaintPicking(Studio& studio) : studio_(studio) {
    const auto pick_next = [this](tools::Pick pick) {
        return
            [this, pick](bool picks) { pick_at_next_click(picks ? std::optional(pick) : std::nullopt); };
    };
    studio_.commands().on(Command::PickPaint, pick_next(tools::Pick::Paint));
    studio_.commands().on(Command::PickColour, pick_next(tools::Pick::Seen));
    const auto pick_on = [this](document::Surface surface) {
        return [this, surface](const QPointF& place_mm, tools::Pick pick) {
            pick_from(surface, place_mm, pick);
        };
    };
    const auto listen = [&](interactions::OnCanvas* on, document::Surface surface) {
        for (const interactions::Picking* picking :
             std::initializer_list<interactions::Picking*>{&on->pick_next, &on->pick_by_keys})
            connect(picking, &interactions::Picking::picked, this, pick_on(surface));
        connect(&on->buttons, &interactions::Buttons::picked, this, pick_on(surface));
    };
    listen(studio_.on_views()[0], document::Surface::Canvas);
    listen(studio_.on_views()[1], document::Surface::Well);
    for (const auto& [view, surface] : {std::pair(&studio_.canvas(), document::Surface::Canvas),
                                        std::pair(&studio_.well(), document::Surface::Well)})
        connect(view, &view::CanvasView::held, this, [pick = pick_on(surface)](const QPointF& place_mm) {
            pick(place_mm, tools::Pick::Paint);
        });
}

void PaintPicking::pick_at_next_click(std::optional<tools::Pick> pick) {
    studio_.commands().action(Command::PickPaint)->setChecked(pick == tools::Pick::Paint);
    studio_.commands().action(Command::PickColour)->setChecked(pick == tools::Pick::Seen);
    for (interactions::OnCanvas* on : studio_.on_views())
        on->pick_next.arm(pick);
}

/// Where no paint lies, its colour is all there is to pick.
void PaintPicking::pick_from(document::Surface surface, const QPointF& place_mm, tools::Pick pick) {
    pick_at_next_click(std::nullopt);
    const document::Snapshot there = snapshot_of(*studio_.session().snapshot(), surface);
    const auto picked = [&] {
        const film::Medium medium = document::medium_of(studio_.easel().hand().medium);
        return tools::paint_at(there.film, studio_.session().paints_used(), medium, place_mm.x(),
                               place_mm.y());
    };
    const auto paint = pick == tools::Pick::Paint ? picked() : std::nullopt;
    if (paint)
        pick_paint(*paint);
    else
        pick_colour(there, place_mm);
}

void PaintPicking::pick_paint(const tools::PickedPaint& paint) {
    studio_.choose_paint(paint.recipe);
    const QString words = paint.layer == film::PaintLayer::Wet ? tr("Picked up wet paint: %1")
                                                               : tr("Picked up dry paint: %1");
    studio_.report(words.arg(panels::share_words(paint.recipe)));
}

void PaintPicking::pick_colour(const document::Snapshot& there, const QPointF& place_mm) {
    const auto colour = tools::colour_at(there, place_mm.x(), place_mm.y());
    if (!colour) return studio_.report(tr("There is no colour to pick beside the canvas."));
    studio_.choose_paint(tools::colour_paint(*colour));
    studio_.report(
        tr("Picked the colour seen: %1").arg(QString::fromStdString(pigment::hex_colour(*colour))));
}

}  // namespace pastoso::main
