#include "tools/touch_doubt.hpp"

#include <cmath>

namespace pastoso::tools {
namespace {

/// A fill that leaves no paint worth the name.
constexpr double kDryFill = 0.005;

struct Cell {
    int x = 0, y = 0;
};

bool is_closed(const document::Snapshot& snapshot, const Cell& cell) {
    const document::Selection &selected = snapshot.selection, &masked = snapshot.masking.cells;
    return (selected && selected->at(cell.x, cell.y) == 0) ||
           (masked && masked->at(cell.x, cell.y) != 0);
}

bool is_bare_locked(const document::Snapshot& snapshot) {
    const document::LayerStack* layers = snapshot.layers.get();
    return layers != nullptr && document::effective_look(*layers, layers->active).bare_locked;
}

bool leaves_bare(const document::Snapshot& snapshot) {
    return snapshot.brush_load.fill < kDryFill || is_bare_locked(snapshot);
}

}  // namespace

bool may_touch_nothing(const document::Snapshot& snapshot, double x_mm, double y_mm) {
    const film::FilmState& film = snapshot.active ? *snapshot.active : snapshot.film;
    const Cell cell{static_cast<int>(std::floor(x_mm / film.cell_mm)),
                    static_cast<int>(std::floor(y_mm / film.cell_mm))};
    if (!film.shape.contains(cell.x, cell.y) || is_closed(snapshot, cell)) return true;
    return film.thickness.at(cell.x, cell.y) == 0 && leaves_bare(snapshot);
}

}  // namespace pastoso::tools
