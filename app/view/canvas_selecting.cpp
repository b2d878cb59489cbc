// The part of CanvasView that draws the outlines of areas, and shows what is selected.

#include "view/canvas_view.hpp"

#include <glm/common.hpp>

namespace pastoso::view {
namespace {

/// Shift adds, Alt takes away, both keep what is common.
grid::Combination combination(Qt::KeyboardModifiers modifiers) {
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    if (modifiers.testFlag(Qt::AltModifier))
        return shift ? grid::Combination::Intersect : grid::Combination::Subtract;
    return shift ? grid::Combination::Add : grid::Combination::Replace;
}

}  // namespace

void CanvasView::draw_areas(std::optional<AreaForm> form) {
    area_form_ = form;
    area_drag_.cancel();
    set_cursor();
}

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

void CanvasView::press_area(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    area_drag_.press(*area_form_, canvas_mm(position), combination(modifiers));
    Q_EMIT area_begun(area_drag_.how());
}

void CanvasView::drag_area(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    const double px_mm = mm_per_px();
    area_drag_.move(canvas_mm(position), px_mm, modifiers.testFlag(Qt::ControlModifier));
    update();
}

void CanvasView::release_area() {
    if (!area_drag_.active()) return;
    const grid::Combination how = area_drag_.how();
    const auto area = area_drag_.release(mm_per_px());
    update();
    if (area)
        Q_EMIT area_drawn(*area);
    else
        Q_EMIT area_clicked(how);
}

/// Escape gives up the outline that is being drawn, or else goes back to painting.
void CanvasView::leave_areas() {
    if (area_drag_.active()) {
        area_drag_.cancel();
        update();
        Q_EMIT area_given_up();
    } else if (area_form_) {
        draw_areas(std::nullopt);
        Q_EMIT areas_left();
    } else {
        Q_EMIT escaped();
    }
}

void CanvasView::draw_selection() {
    const OverlayFrame canvas = overlay_frame(view_.device_from_cell({0.0, 0.0}));
    const document::Selection& selection = preview_ ? *preview_ : shown_->selection;
    if (outline_shown_ || preview_)
        overlay_.draw_dashes(selection_outline_.lines_mm(selection, shown_->film.cell_mm, seen_cells()),
                             canvas);
    if (area_drag_.active()) overlay_.draw_loop(area_drag_.outline_mm(), canvas, 1.0F);
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
