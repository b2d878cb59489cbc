// What a large step needs of a tile between its phases. Faces are stored with the cell on their left or
// above them; those at the tile's left and top edge are kept as well, with the same bits as in the
// neighbour.
#pragma once

#include "film/explicit/tile_step.hpp"
#include "film/large/large_tile_state.hpp"
#include "grid/tile_block.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace pastoso::film {

using CellArray = std::array<float, grid::kTileCells>;

/// The margin that a tile's local solve takes from its neighbours, and what that solve reads around it.
inline constexpr int kOverlap = 8;
inline constexpr int kPatchSize = grid::kTileSize + 2 * kOverlap;
inline constexpr int kWindowMargin = kOverlap + 1;
inline constexpr int kWindowSize = grid::kTileSize + 2 * kWindowMargin;
inline constexpr int kWindowStride = 96;
inline constexpr int kWindowCells = kWindowSize * kWindowStride;
/// Where a window's row keeps the tile's first cell: at the beginning of a cache line.
inline constexpr int kWindowFirst = 16;
static_assert(kWindowFirst >= kWindowMargin &&
              kWindowFirst + kWindowSize <= kWindowStride + kWindowMargin);
using WindowArray = std::array<float, kWindowCells>;

using PatchArray = std::array<float, kPatchSize * kPatchSize>;

/// The index of cell (x, y) of the tile in a window, -kWindowMargin <= x, y < kTileSize + kWindowMargin.
constexpr int window_index(int x, int y) {
    return (y + kWindowMargin) * kWindowStride + x + kWindowFirst;
}

/// A cell that holds less, among such, is not overfilled by its four faces in a step, which carries
/// paint by a cell at most.
inline constexpr std::int32_t kCrowded_quanta = kMaxThickness_quanta / 8;

/// The faces of one direction.
struct LargeFaces {
    alignas(64) FaceArray<float> first;       ///< velocity that the last pressure would make, or
                                              ///< the old one (carrying_velocity()), mm/s
    alignas(64) FaceArray<float> driven;      ///< with inertia and forces, but for drag and new pressure
    alignas(64) FaceArray<float> across;      ///< the same along the face
    alignas(64) FaceArray<float> drag;        ///< lambda dt; negative at faces that are explicit
    alignas(64) FaceArray<float> resistance;  ///< wall stress in yield stresses per velocity, s/mm; 0
                                              ///< without a yield stress
    alignas(64) FaceArray<float> index;  ///< d ln(drag)/d ln(velocity); of shear-thinning paint only
    alignas(64) FaceArray<float> depth;       ///< thickness of the film that passes, mm
    alignas(64) FaceArray<float> star;        ///< velocity but for the new pressure, mm/s
    alignas(64) FaceArray<float> mobility;    ///< flux per pressure difference, mm / (mm2/s2)
    alignas(64) FaceArray<float> weight;      ///< of the slope in the surface's linear response
    alignas(64) FaceArray<float> velocity;    ///< after the step, mm/s
};

/// How far the cells of a tile cannot grant their outflow.
struct Shortage {
    int short_cells = 0;        ///< that grant less than nine tenths of it
    int thick_short_cells = 0;  ///< of these, thicker than a twentieth of a cell size
    bool is_any = false;        ///< a cell grants less than all
};

struct LargeTile {
    LargeFaces x, y;

    alignas(64) CellArray source;         ///< f, change of thickness without the new pressure, mm
    alignas(64) CellArray rest_pressure;  ///< Pi of the old surface, mm2/s2; 0 where dry
    alignas(64) CellArray pressure;       ///< p, that of the new surface, as far as it is known
    alignas(64) CellArray change;         ///< d = f - A p, of thickness, mm
    alignas(64) CellArray residual;       ///< Pi + S d - p
    alignas(64)
        PatchArray correction;  ///< of p, found by the sweep under way in the tile and its overlap
    alignas(64) CellArray share;           ///< of a cell's outflow that is granted, 0..1
    alignas(64) CellArray next_share;      ///< the same after the pass under way
    alignas(64) CellArray supply;          ///< what a cell holds over what leaves it in the step
    float largest_mobility = 0.0F;         ///< of its faces
    float flux_error = 0.0F;               ///< by what part its last drag got a flux wrong
    float fastest_mm_s = 0.0F;             ///< the largest velocity before the step
    float fastest_retreat_mm_s = 0.0F;     ///< of the ends that draw back, by what they fill of a cell
    Shortage shortage;                     ///< of `share`
    int clamped_faces = 0;                 ///< whose velocity was cut to the capacity left ahead
    bool needs_inflow = false;             ///< a cell cannot grant its outflow from what it holds
    bool inertial = false;  ///< the old velocity of some of its paint matters for the new one
    bool crowded = false;   ///< the same: a cell, or one of its margin, has more than kCrowded_quanta
    LargeTileState state;
};

/// Multigrid on a patch: 80, 40, 20 and 10 cells a side.
inline constexpr int kMultigridLevels = 4;

/// Values that begin at a cache line.
class LevelValues {
  public:
    void assign(std::size_t count, float value) { lines_.assign(count / kLineFloats + 1, Line(value)); }
    float* data() { return lines_.data()->values; }
    const float* data() const { return lines_.data()->values; }
    float& operator[](std::size_t index) { return data()[index]; }
    const float& operator[](std::size_t index) const { return data()[index]; }

  private:
    static constexpr std::size_t kLineFloats = 16;
    struct alignas(64) Line {
        float values[kLineFloats];
        explicit Line(float value) { std::fill_n(values, kLineFloats, value); }
    };
    std::vector<Line> lines_;
};

/// A level's cells in checkerboard order, so that a relaxation of one colour runs over neighbouring
/// values: row by row, first the cells with even x + y, then the others, with zeros between them. Rows
/// begin at a cache line.
struct MultigridLevel {
    int size = 0;
    grid::Rect within;             ///< cells within open edges of the canvas, in whole or in part
    LevelValues pressure, change;  ///< the unknowns p and d
    LevelValues pressure_source, change_source;  ///< right-hand sides; the finest level's second is zero
    LevelValues mobility_x, mobility_y;          ///< of the face behind the cell
    LevelValues weight_x, weight_y;
    LevelValues inverse;                             ///< 1 / (1 + a s) for a = sum m, s = g + sum w
    LevelValues pressure_residual, change_residual;  ///< of the even cells

    int half() const { return size / 2; }
    int stride() const { return (size / 2 / 16 + 1) * 16; }
    /// The index of the first cell of a row's colour (0: even x + y), -1 <= y <= size.
    int row(int y, int colour) const { return ((y + 1) * 2 + colour) * stride() + 16; }
    int cell(int x, int y) const { return row(y, (x + y) & 1) + x / 2; }
    int count() const { return row(size + 1, 0); }
};

/// What one thread needs for the large step of a tile; reused from tile to tile.
struct LargeScratch {
    LargeScratch();
    alignas(64) BlockArray<float> lagged_pressure{};
    alignas(64) WindowArray pressure{}, change{}, residual{}, share{};
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

/// The edges of the canvas that a tile touches and that are not periodic.
using CanvasEdges = OpenEdges;

}  // namespace pastoso::film
