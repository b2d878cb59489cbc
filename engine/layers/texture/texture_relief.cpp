#include "layers/texture/texture_relief.hpp"

#include "film/cell/cell_drying.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace pastoso::layers {
namespace {

using Thickness = grid::TileBlock<std::int32_t>;

std::int32_t quanta_of(float height_mm) {
    const auto steps = static_cast<std::int32_t>(std::lround(height_mm / film::kPaintQuantum));
    return steps * static_cast<std::int32_t>(film::kQuantaPerCarried);
}

}  // namespace

CellHeights texture_heights(const Texture& texture, const grid::Rect& cells, double cell_mm) {
    if (const auto* sand = std::get_if<SandTexture>(&texture))
        return sand_heights(*sand, cells, cell_mm);
    if (const auto* knifed = std::get_if<KnifedTexture>(&texture))
        return knifed_heights(*knifed, cells, cell_mm);
    return pressed_heights(std::get<PressedTexture>(texture), cells, cell_mm);
}

grid::TiledField<std::int32_t> texture_relief(const Texture& texture, grid::Shape shape, double cell_mm,
                                              const grid::Mask* where, core::ThreadPool& pool) {
    std::vector<int> tiles;
    for (int tile = 0; tile < shape.tile_count(); ++tile)
        if (where == nullptr || !grid::chooses_none(*where, tile)) tiles.push_back(tile);
    std::vector<Thickness> made(tiles.size());
    pool.run(tiles.size(), [&](std::size_t index, int) {
        const int tile = tiles[index];
        const grid::Rect cells = shape.tile_cells(tile);
        const CellHeights heights_mm = texture_heights(texture, cells, cell_mm);
        made[index] = Thickness::filled(0);
        std::int32_t* thickness = made[index].write();
        const float* height_mm = heights_mm.data();
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x, ++height_mm) {
                const int cell = grid::Shape::cell_in_tile(x, y);
                const std::uint8_t share = where == nullptr ? grid::kWhole : where->read(tile)[cell];
                thickness[cell] = quanta_of(*height_mm * grid::fraction_of(share));
            }
    });
    grid::TiledField<std::int32_t> relief(shape);
    for (std::size_t index = 0; index < tiles.size(); ++index)
        relief.replace(tiles[index], std::move(made[index]));
    return relief;
}

}  // namespace pastoso::layers
