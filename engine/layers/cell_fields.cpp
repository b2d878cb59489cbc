#include "layers/cell_fields.hpp"

namespace pastoso::layers {

MediaCells told_media(const film::FilmState& layer) {
    MediaCells told(layer.shape);
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile) {
        if (layer.thickness.is_background(tile)) continue;
        film::MediaCell* cells = told.write(tile);
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            cells[cell] = film::media_in(layer, tile, cell);
    }
    return told;
}

void put_media(const MediaCells& told, film::FilmState& layer) {
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile)
        if (!told.is_background(tile)) film::set_media(layer, tile, told.block(tile));
}

}  // namespace pastoso::layers
