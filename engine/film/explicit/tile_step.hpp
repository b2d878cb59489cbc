// One explicit step of one tile, compiled for every instruction set; the solver calls the one that fits.
#pragma once

#include "core/kernels.hpp"
#include "film/cell/lower_stratum.hpp"
#include "film/explicit/halo_block.hpp"
#include "film/step_constants.hpp"

#include <array>
#include <limits>
#include <vector>

namespace pastoso::film {

/// Faces of a tile along one axis, with the low edge: index (line, i), i = -1..63.
inline constexpr int kFaceStride = 80;
inline constexpr int kFaceCount = (grid::kTileSize + 1) * kFaceStride;
constexpr int face_index(int x, int y) {
    return (y + 1) * kFaceStride + x + 1;
}

template <class T>
using FaceArray = std::array<T, kFaceCount>;

/// How the film ends in the cells beside dry ones; see FilmEnd. In the middle of the film only `slope`,
/// 0 there, means something.
struct FilmEnds {
    alignas(64) BlockArray<float> normal_x, normal_y;  ///< |n| components of the film's outline
    alignas(64) BlockArray<float> contact_slope, slope, reach_mm, depth_x_mm,
        depth_y_mm, over_x_mm, over_y_mm;
};

/// What one thread needs to step a tile; reused from tile to tile.
struct TileScratch {
    HaloBlock block;
    bool large_fluxes = false;  ///< fluxes may take more than a quarter of their cell
    /// With large fluxes: what a cell holds over what leaves it in the step.
    alignas(64) BlockArray<float> supply;
    FilmEnds ends;                                     ///< of paint with a contact angle
    alignas(64) BlockArray<float> slope_x, slope_y;    ///< contact-aware surface slopes at the faces
    alignas(64) BlockArray<float> pressure;            ///< Pi, mm2/s2
    alignas(64) BlockArray<float> curvature;           ///< kappa, 1/mm
    /// Of the surface in half the step, by the old velocities.
    alignas(64) BlockArray<float> rise_mm;

    /// x faces hold (x, y) with x = -1..63, y = 0..63; y faces x = 0..63, y = -1..63.
    alignas(64) FaceArray<float> velocity_x, velocity_y;
    alignas(64) FaceArray<std::int32_t> flux_x, flux_y;  ///< quanta of thickness this step
};

/// The velocity profile of a film, by the height of its peak (strata_transport.hpp).
struct FilmProfile {
    float alpha = 1.0F;
    float width = 2.0F;  ///< 3 alpha - 1
};

/// The worked part of a tile's paint on its way (structure_transport.hpp).
struct StructureScratch {
    alignas(64) BlockArray<std::int32_t> quanta;  ///< b
    alignas(64) BlockArray<float> share;          ///< b / h
    alignas(64) BlockArray<float> structure_share, breakdown_strain;  ///< theta and gamma_b of the paint
    alignas(64) FaceArray<std::int32_t> flux_x, flux_y;
};
struct StructureStep {
    float
        shear_quanta;  ///< gamma of a step that carries all of a cell, times how many quanta it is thick
};

/// Which faces of a tile are shut: a wall, a neighbour that sleeps or has other paint to wait for; and,
/// where the tile only gives and takes at its edges, all inside.
struct ClosedFaces {
    bool left = false, right = false, top = false, bottom = false;
    bool inside = false;
};

/// What runs faster on a smaller part of a tile than this is not seen: paint that settles into a gap of
/// the weave.
inline constexpr double kUnseenArea_mm2 = 0.1;

/// What the step-length control wants to know of a tile.
struct FlowExtremes {
    float mobility = 0.0F;      ///< largest h du/da, mm s
    float thickness_mm = 0.0F;  ///< of flowing film
    float speed_mm_s = 0.0F;    ///< at the end of the film, in a large step, by what it fills of a cell
    float seen_speed_mm_s = 0.0F;  ///< the same, but for what is faster on kUnseenArea_mm2 at most
    int clamped_faces = 0;         ///< at the largest speed, or cut to the capacity left
};

/// From scratch.block to velocities and fluxes at all faces of the tile, edges included. `columns` and
/// `rows` are the tile's cells on the canvas. No flux takes more than a quarter of the cell that it
/// leaves, nor more than a quarter of the capacity left in the one that it enters, so that no cell can
/// be overdrawn or overfilled whatever its other faces do.
using TileFlow = FlowExtremes (*)(const StepConstants& step, int columns, int rows,
                                  const ClosedFaces& closed, TileScratch& scratch);

/// Moves pigment with the fluxes of scratch: upwind concentration with a minmod slope, scaled so that
/// the four outflows of a cell cannot exceed what it holds. `after` is the tile's new pigment;
/// `concentrations` must hold kConcentrationCount floats. Returns what crossed the edges given as open
/// in `runoff_edges`. Where a channel might overflow (kCrowded), `held` is the old pigment of the tile
/// with a margin of one cell, and no more enters a cell through a face than a quarter of what its
/// channel can still count; elsewhere it is null.
inline constexpr int kConcentrationHalo = 2;
inline constexpr int kConcentrationSide = grid::kTileSize + 2 * kConcentrationHalo;
inline constexpr int kConcentrationCount = kConcentrationSide * kConcentrationSide * kPaintChannels;
constexpr int concentration_place(int x, int y) {
    return (y + kConcentrationHalo) * kConcentrationSide + x + kConcentrationHalo;
}
constexpr int concentration_index(int x, int y) {
    return concentration_place(x, y) * kPaintChannels;
}
struct OpenEdges {
    bool left = false, right = false, top = false, bottom = false;
};
inline constexpr int kHeldSide = grid::kTileSize + 2;
constexpr int held_index(int x, int y) {
    return (y + 1) * kHeldSide + x + 1;
}
/// No cell can gain more than its four neighbours hold.
inline constexpr std::int32_t kCrowded = std::numeric_limits<std::int32_t>::max() / 5;
struct PigmentMoved {
    std::array<std::int64_t, kPaintChannels> runoff{};
    int held_back_faces = 0;  ///< where a full channel let only part of the pigment through
};
using PigmentTransport = PigmentMoved (*)(const TileScratch& scratch, const float* concentrations,
                                          const PaintCell* held, int columns, int rows,
                                          const OpenEdges& runoff_edges, const PaintCell* before,
                                          PaintCell* after);

/// Pigment quanta per thickness quantum of `count` neighbouring cells, a hair below the exact ratio so
/// that rounding never overdraws a cell; 0 where there is no paint. Returns the largest amount in any
/// channel.
using Concentrate = std::int32_t (*)(const PaintCell* pigment, const std::int32_t* thickness, int count,
                                     float* out);

/// Cells in two strata, the lower a part of the whole, or in one, which has no lower.
struct WetStrataCells {
    const PaintCell* paint;
    const std::int32_t* thickness;
    const PaintCell* lower_paint;
    const std::int32_t* lower_thickness;
};
/// Cells whose concentrations are read (concentration_place): not 0.
using ReadCells = std::array<std::uint8_t, kConcentrationSide * kConcentrationSide>;

/// The same of both strata, for cells that are `read`; paint that is one counts as the lower. Where
/// there are two, each counts for four quanta thicker: the shares of a flux are whole quanta, so that
/// four faces may take as many too many.
using ConcentrateStrata = std::int32_t (*)(const WetStrataCells& cells, const std::uint8_t* read,
                                           int count, float* lower, float* upper);

/// What a step makes of the lower stratum of a cell.
struct LowerChange {
    std::int32_t cell = 0;
    LowerCell lower;
};

/// What moves with the upper strata of a tile, and how far the strata mix. Paint that is one has none.
struct StrataScratch {
    std::vector<float> concentrations;
    BlockArray<std::uint8_t> passed;   ///< not 0 where something passes a face of the cell
    ReadCells read;                    ///< those cells and the ones beside them
    std::vector<LowerChange> changes;  ///< room for all cells
    alignas(64) BlockArray<std::int32_t> quanta;
    alignas(64) BlockArray<float> share;  ///< of what leaves a cell, the upper stratum's
    alignas(64) BlockArray<float> supply;
    alignas(64) FaceArray<std::int32_t> flux_x, flux_y;
    alignas(64) std::array<float, grid::kTileCells> mixing;  ///< share of what can that mixes
};

/// Finds the cells that the fluxes pass, and whose concentrations they read.
using FindReadCells = void (*)(const TileScratch& scratch, int columns, int rows, StrataScratch& strata);

/// Splits the fluxes, the thickness and (with large fluxes) the supply that the scratch holds into those
/// of both strata: the lower one's stay there. `upper.quanta` is known.
using SplitStrata = void (*)(const FilmProfile& profile, float cell_quanta, TileScratch& scratch,
                             StrataScratch& upper);

/// The paint of a tile in two strata before a step and after it; `held` as for PigmentTransport.
struct StrataPaint {
    const float* lower_concentrations;
    const PaintCell* held;
    const PaintCell *whole_before, *lower_before;
    const std::int32_t* thickness;  ///< whole, afterwards
    PaintCell* whole;               ///< to be filled
    LowerChange* changes;           ///< likewise, for cells that have two strata or had them
};
struct StrataMoved {
    PigmentMoved pigment;
    int changes = 0;
};
/// Moves both strata, each by its own fluxes as paint is moved; joins those that are lost, and lets
/// others mix.
using TransportStrata = StrataMoved (*)(const TileScratch& scratch, const StrataScratch& upper,
                                        int columns, int rows, const OpenEdges& runoff_edges,
                                        const StrataPaint& paint);

/// h_new = h - div(flux) in whole quanta for all 64 x 64 cells; what it writes beyond the canvas means
/// nothing.
using ApplyFluxes = void (*)(const TileScratch& scratch, std::int32_t* after);

/// The largest |after - before| of each column over the given rows of a tile.
using ColumnChanges = std::array<std::int32_t, grid::kTileSize>;
using LargestChanges = void (*)(const std::int32_t* before, const std::int32_t* after, int first_row,
                                int last_row, ColumnChanges& changes);

/// nu, mm2/s, and tau_y/rho, mm2/s2, of `count` neighbouring cells.
using CellRheology = void (*)(const PaintCell* paint, const std::int32_t* thickness, int count,
                              float yield_per_Pa, float* viscosity, float* yield);

/// Both of `count` cells times 1 - structure_share b / h, with each one's own.
using Loosen = void (*)(const std::int32_t* worked, const std::int32_t* thickness, int count,
                        const float* structure_share, float* viscosity, float* yield);

/// The worked paint after a step, of all 64 x 64 cells; what it writes beyond the canvas means nothing.
using MoveStructure = void (*)(const StructureStep& step, const TileScratch& scratch,
                               StructureScratch& structure, const std::int32_t* thickness_after,
                               std::int32_t* worked_after);

struct TileKernels {
    TileFlow flow = nullptr;
    PigmentTransport transport = nullptr;
    Concentrate concentrate = nullptr;
    FindReadCells find_read_cells = nullptr;
    ConcentrateStrata concentrate_strata = nullptr;
    SplitStrata split_strata = nullptr;
    TransportStrata transport_strata = nullptr;
    ApplyFluxes apply_fluxes = nullptr;
    LargestChanges largest_changes = nullptr;
    CellRheology rheology = nullptr;
    Loosen loosen = nullptr;
    MoveStructure move_structure = nullptr;

    static const TileKernels baseline, avx2, avx512;
};

}  // namespace pastoso::film
