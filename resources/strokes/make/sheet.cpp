#include "core/units.hpp"
#include "lettering.hpp"
#include "paths.hpp"
#include "scenes.hpp"
#include "sheet_parts.hpp"

namespace pastoso::examples {

void Field::label(Painter& painter, std::string_view words) const {
    painter.take_own(lettering_pen(0.8));
    painter.dip(load(mixture("PBk9 PB29=0.4")));
    write(painter, words, corner + Point{2.5, 1.8}, 3.6);
}

document::Recording sheet() {
    document::CanvasSettings canvas;
    canvas.width_mm = kSheetColumns * Field::kWidth_mm;
    canvas.height_mm = kSheetRows * Field::kHeight_mm;
    canvas.px_per_mm = 5;
    canvas.support = "linen";
    Painter painter(canvas);
    painter.use_medium("heavy-body oil");
    paint_sheet_grounds(painter);
    paint_sheet_fluids(painter);
    painter.dry_now();
    paint_sheet_brushes(painter);
    paint_sheet_effects(painter);
    paint_sheet_colours(painter);
    paint_sheet_tools(painter);
    return painter.finish(1.0);
}

}  // namespace pastoso::examples
