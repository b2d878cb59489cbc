// One step of one tile, from the old state to what is new in it. Reads the state, writes only its
// result.
#pragma once

#include "film/air_jet.hpp"
#include "film/explicit/halo_block.hpp"
#include "film/explicit/tile_step.hpp"
#include "film/large/large_tile.hpp"
#include "film/tile_activity.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace pastoso::film {

/// What a thread needs for the tiles that it steps.
struct WorkerScratch {
    TileScratch tile{};
    std::vector<float> concentrations = std::vector<float>(kConcentrationCount);
    std::vector<PaintCell> held;  ///< of crowded tiles
    std::unique_ptr<StrataScratch> strata = std::make_unique<StrataScratch>();
    std::unique_ptr<StructureScratch> structure = std::make_unique<StructureScratch>();
};

/// Where a tile lies and what surrounds it.
struct TilePlace {
    int tile = 0, tile_x = 0;
    const HaloMap& columns;
    const HaloMap& rows;
    ClosedFaces closed;
    OpenEdges runoff_edges;
    CanvasEdges canvas_edges;
    std::span<const AirJet> air;  ///< what blows on the canvas
    const grid::Mask* cover = nullptr;  ///< whose cells no paint enters or leaves; null: none
    double density_kg_m3 = 1000.0;
    bool pigment_in_reach = true;          ///< false: nothing here or beside it is coloured
    const std::int32_t* motion_reference;  ///< thickness that the tile's motion is counted from
};

/// What a step makes of a tile. An empty block means that the field did not change.
struct TileResult {
    grid::TileBlock<std::int32_t> thickness;
    grid::TileBlock<PaintCell> paint;
    std::vector<LowerChange> lower;
    grid::TileBlock<std::int32_t> worked;
    grid::TileBlock<MediaCell> media;
    grid::TileBlock<float> velocity_x, velocity_y;
    FlowExtremes extremes;
    SideSpeeds side_speeds_mm_s{};
    std::optional<TileMotion> motion;
    Totals runoff;
};

/// Whether is_it(tile) of any tile that a step of this one reads.
template <class IsIt>
bool any_tile_near(const TilePlace& place, int tiles_x, const IsIt& is_it) {
    int last_row = -1;
    for (const HaloSource& row : place.rows.cells) {
        if (row.outside || row.tile == last_row) continue;
        last_row = row.tile;
        int last_column = -1;
        for (const HaloSource& column : place.columns.cells) {
            if (column.outside || column.tile == last_column) continue;
            last_column = column.tile;
            if (is_it(row.tile * tiles_x + column.tile)) return true;
        }
    }
    return false;
}

/// Sets the cells of a tile that lie beyond its `columns` and `rows` on the canvas to 0.
void clear_beyond(std::int32_t* values, int columns, int rows);

/// A tile's new paint, to be filled where the tile lies on the canvas.
grid::TileBlock<PaintCell> new_paint(const TilePlace& place);

/// Adds what ran off, and faces held back, to the result.
void note_moved(const PigmentMoved& moved, TileResult& result);

/// What the velocities and fluxes in the worker's scratch, and the block gathered there, make of a tile.
TileResult collect_tile(const FilmState& state, const TilePlace& place, const StepConstants& step,
                        const FlowExtremes& extremes, WorkerScratch& worker);

/// Gathers what a step of the tile reads into the worker's scratch.
void gather_tile(const FilmState& state, const TilePlace& place, const StepConstants& step,
                 WorkerScratch& worker);

/// One explicit step.
TileResult update_tile(const FilmState& state, const TilePlace& place, const StepConstants& step,
                       WorkerScratch& worker);

}  // namespace pastoso::film
