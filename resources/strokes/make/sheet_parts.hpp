// The parts of the reference sheet: what every tool does, each in a field of its own.
#pragma once

#include "paths.hpp"

namespace pastoso::examples {

inline constexpr int kSheetColumns = 6, kSheetRows = 9;

/// A field of the sheet.
struct Field {
    static constexpr double kWidth_mm = 68.0, kHeight_mm = 38.0;

    Field(int column, int row) : corner{column * kWidth_mm, row * kHeight_mm} {}

    /// A place of the field, from its upper left corner.
    Point at(double x_mm, double y_mm) const { return corner + Point{x_mm, y_mm}; }

    Point corner;
};

/// What has to be dry before the rest is painted: the bars below the glazes.
void paint_sheet_grounds(Painter& painter);

/// Runny paint, which has to be dry too before the rest is painted: it would go on running.
void paint_sheet_fluids(Painter& painter);
void paint_sheet_marbling(Painter& painter);

void paint_sheet_brushes(Painter& painter);
void paint_sheet_effects(Painter& painter);
void paint_sheet_tools(Painter& painter);
void paint_sheet_workshop(Painter& painter);
void paint_sheet_colours(Painter& painter);

}  // namespace pastoso::examples
