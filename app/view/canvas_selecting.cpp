// The part of CanvasView that shows what is selected.

#include "screen/window_pixels.hpp"
#include "view/canvas_view.hpp"

namespace pastoso::view {
void CanvasView::show_outline(bool shown) {
    outline_shown_ = shown;
    screen_->refresh();
}

void CanvasView::preview_selection(std::optional<document::Selection> preview) {
    // One of a canvas that is not shown yet comes again when it is.
    const bool fits = !preview || *preview == nullptr || wanted_ == nullptr ||
                      (*preview)->shape() == wanted_->film.shape;
    preview_ = fits ? std::move(preview) : std::nullopt;
    screen_->refresh();
}

void CanvasView::draw_selection(const document::Snapshot& shown, const Overlay& overlay) {
    const document::Selection& selection = preview_ ? *preview_ : shown.selection;
    if (!outline_shown_ && !preview_) return;
    const grid::Rect cells = screen::seen_cells(view_, screen::window_px(*this), shown.film.shape);
    overlay.painter.draw_dashes(selection_outline_.lines_mm(selection, shown.film.cell_mm, cells),
                                overlay.canvas);
}

}  // namespace pastoso::view
