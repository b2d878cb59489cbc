// What a large step keeps of a tile between its phases. Faces are stored with the cell on their left or
// above them; those at the tile's left and top edge are kept as well, with the same bits as in the
// neighbour.
#pragma once

#include "film/tile_step.hpp"

#include <array>
#include <vector>

namespace pastoso::film {

using CellArray = std::array<float, grid::kTileCells>;

/// The margin that a tile's local solve takes from its neighbours, and what that solve reads around it.
inline constexpr int kOverlap = 8;
inline constexpr int kPatchSize = grid::kTileSize + 2 * kOverlap;
inline constexpr int kWindowMargin = kOverlap + 2;
inline constexpr int kWindowSize = grid::kTileSize + 2 * kWindowMargin;
inline constexpr int kWindowStride = 96;
inline constexpr int kWindowCells = kWindowSize * kWindowStride;
using WindowArray = std::array<float, kWindowCells>;

using PatchArray = std::array<float, kPatchSize * kPatchSize>;

/// The index of cell (x, y) of the tile in a window, -kWindowMargin <= x, y < kTileSize + kWindowMargin.
constexpr int window_index(int x, int y) {
    return (y + kWindowMargin) * kWindowStride + x + kWindowMargin;
}

struct LargeTile {
    alignas(64) FaceArray<float> star_x, star_y;          ///< velocity but for the new pressure, mm/s
    alignas(64) FaceArray<float> velocity_x, velocity_y;  ///< with it
    alignas(64) FaceArray<float> old_x, old_y;            ///< before the step
    alignas(64) FaceArray<float> depth_x, depth_y;        ///< thickness of the film that passes, mm
    alignas(64) FaceArray<float> mobility_x,
        mobility_y;                                   ///< flux per pressure difference, mm / (mm2/s2)
    alignas(64) FaceArray<float> weight_x, weight_y;  ///< of the slope in the surface's linear response

    alignas(64) CellArray source;         ///< f, change of thickness without the new pressure, mm
    alignas(64) CellArray rest_pressure;  ///< Pi of the old surface, mm2/s2; 0 where dry
    alignas(64) CellArray pressure;       ///< p, that of the new surface, as far as it is known
    alignas(64)
        PatchArray correction;  ///< of p, found by the sweep under way in the tile and its overlap
    alignas(64) CellArray last_pressure;  ///< p of the last step, 0 where unknown
    alignas(64) CellArray share;          ///< of a cell's outflow that is granted, 0..1
    alignas(64) CellArray next_share;     ///< the same after the pass under way
    alignas(64) CellArray supply;         ///< what a cell holds over what leaves it in the step
    float residual = 0.0F;                ///< found by the last sweep
    bool stubborn = false;                ///< a single V-cycle does not get hold of its residual
    bool unsteady = false;  ///< its drag, or that of a tile beside it, still changes with its flow
};

/// Multigrid on a patch: 80, 40, 20 and 10 cells a side.
inline constexpr int kMultigridLevels = 4;

/// A level's cells in checkerboard order, so that a relaxation of one colour runs over neighbouring
/// values: row by row, first the cells with even x + y, then the others, each with a zero on either
/// side.
struct MultigridLevel {
    int size = 0;
    std::vector<float> pressure, change;                ///< the unknowns p and d
    std::vector<float> pressure_source, change_source;  ///< right-hand sides
    std::vector<float> mobility_x, mobility_y;          ///< of the face behind the cell
    std::vector<float> weight_x, weight_y;
    std::vector<float> mobility_sum, stiffness, inverse;  ///< a, s and 1 / (1 + a s)
    std::vector<float> pressure_residual, change_residual;

    int half() const { return size / 2; }
    int stride() const { return size / 2 + 2; }
    /// The index of the first cell of a row's colour (0: even x + y), -1 <= y <= size.
    int row(int y, int colour) const { return ((y + 1) * 2 + colour) * stride() + 1; }
};

/// What one thread needs for the large step of a tile; reused from tile to tile.
struct LargeScratch {
    LargeScratch();
    alignas(64) BlockArray<float> lagged_pressure{};
    alignas(64) WindowArray pressure{}, change{}, source{}, rest_pressure{}, residual{}, share{};
    alignas(64) WindowArray mobility_x{}, mobility_y{}, weight_x{}, weight_y{};
    alignas(64) std::array<std::int32_t, kWindowCells> thickness{};  ///< quanta
    /// Of the patch's solve, zero outside the patch.
    alignas(64) WindowArray correction{}, direction{}, flow{}, response{};
    alignas(64) WindowArray last_direction{}, last_flow{}, last_response{};
    std::array<MultigridLevel, kMultigridLevels> levels;
};

/// Part of a tile that some tile's patch covers, in cells from `x`, `y` on, and the correction found
/// there.
struct PatchCover {
    const PatchArray* correction;
    int x, y, width, height;
    int patch_x, patch_y;  ///< of its first cell in the patch
};

/// Cells that can grant less than nine tenths of their outflow, and those of them that hold more than a
/// trace (a twentieth of a cell size).
struct Shortage {
    int cells = 0, thick_cells = 0;
};

/// The edges of the canvas that a tile touches and that are not periodic.
using CanvasEdges = OpenEdges;

}  // namespace pastoso::film
