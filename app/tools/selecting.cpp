#include "tools/selecting.hpp"

#include "layers/clipping.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::tools {
namespace {

const film::FilmState& active_film(const document::Snapshot& painting) {
    return painting.active != nullptr ? *painting.active : painting.film;
}

template <class Value>
PaintDepths depths(grid::Shape shape, const Value& value_mm) {
    double sum_mm = 0.0, most_mm = 0.0;
    std::int64_t count = 0;
    for (int tile = 0; tile < shape.tile_count(); ++tile) {
        const grid::Rect cells = shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y) {
            for (int x = cells.x0; x < cells.x1; ++x) {
                const double value = value_mm(tile, grid::Shape::cell_in_tile(x, y));
                if (value < layers::kLeastPaint_mm) continue;
                sum_mm += value;
                most_mm = std::max(most_mm, value);
                ++count;
            }
        }
    }
    return {count > 0 ? sum_mm / static_cast<double>(count) : 0.0, most_mm};
}

bool touches(const grid::Mask& mask, const film::FilmState& film, double x_mm, double y_mm,
             double reach_mm) {
    const double x = x_mm / film.cell_mm, y = y_mm / film.cell_mm;
    const double reach = std::max(reach_mm / film.cell_mm, 1.0);
    const grid::Rect around = grid::intersection(
        film.shape.cells(),
        {static_cast<int>(std::floor(x - reach)), static_cast<int>(std::floor(y - reach)),
         static_cast<int>(std::ceil(x + reach)), static_cast<int>(std::ceil(y + reach))});
    for (int cell_y = around.y0; cell_y < around.y1; ++cell_y) {
        for (int cell_x = around.x0; cell_x < around.x1; ++cell_x) {
            const bool selected = mask.at(cell_x, cell_y) != 0;
            if (selected && std::hypot(cell_x + 0.5 - x, cell_y + 0.5 - y) <= reach) return true;
        }
    }
    return false;
}

}  // namespace

PaintDepths heights_on(const document::Snapshot& painting) {
    const film::FilmState& film = active_film(painting);
    return depths(film.shape, [&](int tile, int cell) {
        return film.support_mm.read(tile)[cell] - painting.bare->support_mm.read(tile)[cell] +
               film::thickness_mm(film.thickness.read(tile)[cell]);
    });
}

PaintDepths wetness_on(const document::Snapshot& painting) {
    const film::FilmState& film = active_film(painting);
    return depths(film.shape, [&](int tile, int cell) {
        return film::thickness_mm(film.thickness.read(tile)[cell]);
    });
}

document::Selection selection_after(const document::Snapshot& painting,
                                    const document::SelectByHeight& select) {
    const grid::Mask area = document::area_of(select, active_film(painting), painting.bare->support_mm);
    return document::combined(painting.selection, area, select.how);
}

document::Selection selection_after(const document::Snapshot& painting,
                                    const document::SelectByWetness& select) {
    return document::combined(painting.selection, document::area_of(select, active_film(painting)),
                              select.how);
}

grid::Rect outlined_area(const document::Selection& selection) {
    return grid::chosen_area(grid::hardened(*selection));
}

bool are_same(const document::Selection& a, const document::Selection& b) {
    const auto is_within = [](const grid::Mask& inner, const grid::Mask& outer) {
        return grid::chosen_area(grid::combined(inner, outer, grid::Combination::Subtract)).empty();
    };
    return is_within(*a, *b) && is_within(*b, *a);
}

double selected_share(const document::Selection& selection) {
    if (selection == nullptr) return 1.0;
    const grid::Shape shape = selection->shape();
    return static_cast<double>(grid::chosen_cells(*selection)) /
           (static_cast<double>(shape.width) * shape.height);
}

bool touches_selection(const document::Snapshot& painting, const brush::Symmetry& symmetry, double x_mm,
                       double y_mm, double reach_mm) {
    if (painting.selection == nullptr) return true;
    const auto copies = brush::placements(symmetry);
    return std::any_of(copies.begin(), copies.end(), [&](const brush::Placement& copy) {
        return touches(*painting.selection, painting.film, copy.xx * x_mm + copy.xy * y_mm + copy.x_mm,
                       copy.yx * x_mm + copy.yy * y_mm + copy.y_mm, reach_mm);
    });
}

}  // namespace pastoso::tools
