#include "screen/look_layer.hpp"

#include "screen/canvas_layers.hpp"

#include <algorithm>

namespace pastoso::screen {

/// What is bare is not known on the well.
float look_thickness_mm(const document::Snapshot& painting, Look look, int x, int y) {
    const film::FilmState& film = painting.film;
    const document::BareCanvas* bare = look == Look::Height ? painting.bare.get() : nullptr;
    const float wet_mm = film::thickness_mm(film.thickness.at(x, y));
    if (bare == nullptr) return wet_mm;
    const int tile = film.shape.tile_at(x, y), cell = grid::Shape::cell_in_tile(x, y);
    return wet_mm + film.support_mm.read(tile)[cell] - bare->support_mm.read(tile)[cell];
}

bool needs_thickness(Look look) {
    return look == Look::Wet || look == Look::Height;
}

std::vector<LookPatch> look_patches(const document::Snapshot& painting, Look look,
                                    const std::vector<int>& tiles, core::ThreadPool& pool) {
    std::vector<LookPatch> patches(tiles.size());
    const grid::Shape& shape = painting.film.shape;
    pool.run(tiles.size(), [&](std::size_t i, int) {
        LookPatch& patch = patches[i];
        patch.cells = tile_with_border(shape, tiles[i]);
        patch.thickness_mm.reserve(static_cast<std::size_t>(patch.cells.width()) * patch.cells.height());
        for (int y = patch.cells.y0; y < patch.cells.y1; ++y)
            for (int x = patch.cells.x0; x < patch.cells.x1; ++x)
                patch.thickness_mm.push_back(look_thickness_mm(painting, look,
                                                               std::clamp(x, 0, shape.width - 1),
                                                               std::clamp(y, 0, shape.height - 1)));
    });
    return patches;
}

double highest_mm(const std::vector<LookPatch>& patches) {
    float highest = 0.0F;
    for (const LookPatch& patch : patches)
        for (const float thickness : patch.thickness_mm)
            highest = std::max(highest, thickness);
    return highest;
}

}  // namespace pastoso::screen
