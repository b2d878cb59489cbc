// The cell below a place of the canvas.
#pragma once

#include "film/state.hpp"

#include <algorithm>

namespace pastoso::brush {

struct Cell {
    int x, y;
};

/// That of the nearest place on the canvas for one beyond its edges.
inline Cell nearest_cell(const film::FilmState& film, double x_mm, double y_mm) {
    return {static_cast<int>(std::clamp(x_mm / film.cell_mm, 0.0, film.shape.width - 1.0)),
            static_cast<int>(std::clamp(y_mm / film.cell_mm, 0.0, film.shape.height - 1.0))};
}

}  // namespace pastoso::brush
