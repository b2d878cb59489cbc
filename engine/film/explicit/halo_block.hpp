// A tile with a margin of its neighbours' cells, gathered into plain arrays: what one step of a tile
// reads.
#pragma once

#include "film/cell/film_numbers.hpp"
#include "film/solver.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"

#include <array>
#include <vector>

namespace pastoso::film {

/// Cells of margin: a face looks two cells to each side, where the film ends two further.
inline constexpr int kHalo = 4;
inline constexpr int kBlockRows = grid::kTileSize + 2 * kHalo;
inline constexpr int kBlockStride = 80;
inline constexpr int kBlockCells = kBlockRows * kBlockStride;

/// The index of cell (x, y) of the tile, -kHalo <= x, y < kTileSize + kHalo.
constexpr int block_index(int x, int y) {
    return (y + kHalo) * kBlockStride + x + kHalo;
}

template <class T>
using BlockArray = std::array<T, kBlockCells>;

/// Where one row or column of a block comes from.
struct HaloSource {
    int tile = 0;           ///< tile column or row
    int cell = 0;           ///< within that tile
    bool outside = false;   ///< beyond an open edge: no paint there
    bool mirrored = false;  ///< beyond a wall: velocities change sign
};

/// The sources of all rows (or columns) of a block along one axis, for cells and for faces. Face i lies
/// between cells i and i + 1.
struct HaloMap {
    std::array<HaloSource, kBlockRows> cells;
    std::array<HaloSource, kBlockRows> faces;
    int extent = 0;  ///< cells of the tile on the canvas along this axis, 1..kTileSize
};
HaloMap make_halo_map(int tile_index, int canvas_cells, Edge edge);

/// The gathered fields; cells that no source reaches hold no paint.
struct HaloBlock {
    alignas(64) BlockArray<float> thickness;  ///< mm
    alignas(64) BlockArray<float> support;    ///< mm
    alignas(64) BlockArray<float> eta;        ///< surface, mm
    alignas(64) BlockArray<float> velocity_x;
    alignas(64) BlockArray<float> velocity_y;
    alignas(64) BlockArray<std::int32_t> quanta;  ///< thickness
    alignas(64) BlockArray<float> viscosity;      ///< mm2/s; of varied paint only (rheology_block.hpp)
    alignas(64) BlockArray<float> yield;          ///< tau_y/rho, mm2/s2; likewise
    alignas(64) BlockArray<float> air;            ///< pressure of air over density, mm2/s2 (air_jet.hpp)
    bool pressed = false;                         ///< whether there is any; else `air` means nothing
    CellNumbers<BlockArray<float>> numbers;       ///< where there are several media (numbers_block.hpp)
    int first_wet_row = 0, last_wet_row = -1;     ///< rows of the block with more than `wet_mm`
    BlockArray<std::uint8_t> covered;             ///< not 0: no paint flows into the cell or out of it
    bool any_covered = false;                     ///< whether there is any; else `covered` means nothing
};

void gather(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
            float wet_mm, HaloBlock& block);

/// Which cells of the mask are covered; null: none.
void gather_covered(const grid::Mask* cover, const HaloMap& columns, const HaloMap& rows, int tile_x,
                    HaloBlock& block);

/// A thickness in quanta alone.
void gather_quanta(const grid::TiledField<std::int32_t>& thickness, const HaloMap& columns,
                   const HaloMap& rows, int tile_x, BlockArray<std::int32_t>& quanta);

}  // namespace pastoso::film
