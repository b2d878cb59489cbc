// The part of CanvasView that shows what is selected.

#include "view/canvas_view.hpp"

#include <glm/common.hpp>

namespace pastoso::view {
void CanvasView::show_outline(bool shown) {
    outline_shown_ = shown;
    update();
}

void CanvasView::preview_selection(std::optional<document::Selection> preview) {
    // One of a canvas that is not shown yet comes again when it is.
    const bool fits = !preview || *preview == nullptr || wanted_ == nullptr ||
                      (*preview)->shape() == wanted_->film.shape;
    preview_ = fits ? std::move(preview) : std::nullopt;
    update();
}

void CanvasView::draw_selection() {
    const document::Selection& selection = preview_ ? *preview_ : shown_->selection;
    if (!outline_shown_ && !preview_) return;
    overlay_.draw_dashes(selection_outline_.lines_mm(selection, shown_->film.cell_mm, seen_cells()),
                         overlay().canvas);
}

grid::Rect CanvasView::seen_cells() const {
    const glm::dvec2 window = window_px();
    glm::dvec2 first = canvas_cells(), last{0.0, 0.0};
    for (const glm::dvec2& px : {{0.0, 0.0}, window, {window.x, 0.0}, {0.0, window.y}}) {
        const glm::dvec2 cell = view_.cell_from_device(px);
        first = glm::min(first, glm::max(glm::floor(cell), 0.0));
        last = glm::max(last, glm::min(glm::ceil(cell), canvas_cells()));
    }
    return {static_cast<int>(first.x), static_cast<int>(first.y), static_cast<int>(last.x),
            static_cast<int>(last.y)};
}

}  // namespace pastoso::view
