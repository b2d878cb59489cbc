#include "main/paint/swatches.hpp"

#include "document/actions/actions.hpp"
#include "panels/colour/colour_panel.hpp"
#include "panels/paint/load_panel.hpp"
#include "panels/paint/paint_panel.hpp"

#include <utility>

namespace pastoso::main {

Swatches::Swatches(Studio& studio, const PanelSet& panels) : studio_(studio), panels_(panels) {
    const view::CanvasView& canvas = studio_.canvas();
    connect(&studio_, &Studio::hand_changed, this, &Swatches::follow_hand);
    connect(&studio_, &Studio::published, this, [this](const auto& painting) {
        follow_ground(*painting);
        if (std::exchange(load_, painting->brush_load) != load_) show_paint_in_hand();
    });
    connect(&canvas, &view::CanvasView::lighting_changed, this, &Swatches::follow_light);
    connect(&canvas, &view::CanvasView::viewing_changed, this, &Swatches::follow_light);
}

void Swatches::follow_hand(const tools::Hand& hand) {
    tools::SwatchView view = view_;
    view.medium = document::medium_of(hand.medium);
    view.spot.film_mm = tools::film_in_hand_mm(hand);
    show(view);
}

void Swatches::follow_ground(const document::Snapshot& painting) {
    if (painting.ground == view_.spot.ground) return;
    tools::SwatchView view = view_;
    view.spot.ground = painting.ground;
    show(view);
}

void Swatches::follow_light() {
    tools::SwatchView view = view_;
    view.spot.lighting = studio_.canvas().lighting();
    view.spot.viewing = studio_.canvas().viewing();
    show(view);
}

void Swatches::show(const tools::SwatchView& view) {
    if (view != view_) {
        view_ = view;
        panels_.paints->show_swatches(view_);
        panels_.load->show_swatches(view_);
        panels_.colours->show_swatches(view_);
    }
    show_paint_in_hand();
}

void Swatches::show_paint_in_hand() {
    const tools::Hand& hand = studio_.easel().hand();
    interactions::PaintInHand paint{.held = tools::wet_colour(load_, view_)};
    if (hand.reload_each_stroke && tools::preset_in_hand(hand).dips)
        paint.dipped = tools::wet_colour(hand.paint, view_);
    studio_.on_canvas().paint.set_paint(paint);
}

}  // namespace pastoso::main
