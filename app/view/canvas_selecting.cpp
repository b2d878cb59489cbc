// The part of CanvasView that shows what is selected, and what is masked.

#include "screen/window_pixels.hpp"
#include "view/canvas_view.hpp"

#include <algorithm>

#include <QPainter>
#include <QTransform>

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

void CanvasView::draw_masking(const document::Snapshot& shown, const Overlay& overlay) {
    const QImage& skin = masking_skin_.picture(shown.masking);
    if (skin.isNull()) return;
    const grid::Shape shape = shown.film.shape;
    const double cell_mm = shown.film.cell_mm;
    // The last pixels may stand for cells beyond the canvas.
    const int block = std::max((shape.width + skin.width() - 1) / skin.width(),
                               (shape.height + skin.height() - 1) / skin.height());
    const glm::dvec2 side_mm = cell_mm * block * glm::dvec2(skin.width(), skin.height());
    const QPointF origin = widget_position({0.0, 0.0});
    const QPointF across = (widget_position({side_mm.x, 0.0}) - origin) / skin.width();
    const QPointF down = (widget_position({0.0, side_mm.y}) - origin) / skin.height();
    overlay.painter.draw([&](QPainter& painter) {
        painter.setTransform(
            QTransform(across.x(), across.y(), down.x(), down.y(), origin.x(), origin.y()), true);
        painter.drawImage(QPointF(0.0, 0.0), skin);
    });
}

void CanvasView::draw_selection(const document::Snapshot& shown, const Overlay& overlay) {
    const document::Selection& selection = preview_ ? *preview_ : shown.selection;
    if (!outline_shown_ && !preview_) return;
    const grid::Rect cells = screen::seen_cells(view_, screen::window_px(*this), shown.film.shape);
    overlay.painter.draw_dashes(selection_outline_.lines_mm(selection, shown.film.cell_mm, cells),
                                overlay.canvas);
}

}  // namespace pastoso::view
