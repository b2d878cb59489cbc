#include "core/units.hpp"
#include "lettering.hpp"
#include "paths.hpp"
#include "scenes.hpp"
#include "sheet_parts.hpp"

namespace pastoso::examples {
namespace {

constexpr double kLetterHeight_mm = 3.0;

/// What stands in the upper left corners of the fields, row by row.
constexpr const char* kCaptions[kSheetRows][kSheetColumns] = {
    {"flat bristle", "bright", "filbert", "large filbert", "fan", "impasto flat"},
    {"round sable", "round bristle", "rigger", "detail round", "mop", "stippler"},
    {"dry brush", "wet in wet", "half mixed", "double load", "blender", "dipped tip"},
    {"scumble on dry", "glazes on dry", "palette knife", "spreading knife", "scraper", "diamond knife"},
    {"lifting knife", "comb", "rag", "cotton bud and eraser", "blotting pad", "fingertip"},
    {"dropper", "spray can", "airbrush", "spatter", "pouring bottle", "straw"},
    {"thinner brush", "large flat", "fine comb", "air blower", "soft glazing flat", "symmetry"},
    {"nib and ruling pen", "charcoal and pastel", "sponge", "roller", "squeegee", "marbling comb"},
    {"tints", "tints", "yellow and blue", "yellow with red and black", "greys in white",
     "violets in white"}};

void write_captions(Painter& painter) {
    painter.take_own(lettering_pen(0.5));
    for (int row = 0; row < kSheetRows; ++row)
        for (int column = 0; column < kSheetColumns; ++column) {
            painter.wipe();
            painter.dip(load(mixture("PBk9 PB29=0.4")));
            write(painter, kCaptions[row][column], Field(column, row).at(2.5, 1.8), kLetterHeight_mm);
        }
}

}  // namespace

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
    paint_sheet_workshop(painter);
    write_captions(painter);
    return painter.finish(0.1);
}

}  // namespace pastoso::examples
