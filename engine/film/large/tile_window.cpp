#include "film/large/tile_window.hpp"

namespace pastoso::film {

using grid::kTileSize;

std::vector<WindowRun> window_runs(int tile_index, int canvas_cells, Edge edge, int margin) {
    const int first = tile_index * kTileSize;
    std::vector<WindowRun> runs;
    for (int position = 0; position < kTileSize + 2 * margin; ++position) {
        int cell = first + position - margin;
        if (edge == Edge::Periodic) cell = (cell % canvas_cells + canvas_cells) % canvas_cells;
        if (cell < 0 || cell >= canvas_cells) continue;
        const int tile = cell / kTileSize, within = cell % kTileSize;
        const bool continues = !runs.empty() && runs.back().tile == tile &&
                               runs.back().position + runs.back().count == position &&
                               runs.back().cell + runs.back().count == within;
        if (continues)
            ++runs.back().count;
        else
            runs.push_back({.position = position, .count = 1, .tile = tile, .cell = within});
    }
    return runs;
}

std::vector<WindowRun> covering_runs(int tile_index, int canvas_cells, Edge edge, int margin) {
    std::vector<WindowRun> result;
    for (int tile = 0; tile * kTileSize < canvas_cells; ++tile)
        for (WindowRun run : window_runs(tile, canvas_cells, edge, margin)) {
            if (run.tile != tile_index) continue;
            run.tile = tile;
            result.push_back(run);
        }
    return result;
}

}  // namespace pastoso::film
