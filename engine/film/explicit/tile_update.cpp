#include "film/explicit/tile_update.hpp"

#include "film/explicit/air_block.hpp"
#include "film/explicit/concentration_block.hpp"
#include "film/explicit/numbers_block.hpp"
#include "film/explicit/rheology_block.hpp"
#include "film/explicit/strata_transport.hpp"
#include "film/explicit/structure_transport.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

using grid::kTileSize;
using grid::TileBlock;

bool any_flux(const FaceArray<std::int32_t>& flux, int first_x, int first_y, int columns, int rows) {
    for (int y = first_y; y < rows; ++y)
        for (int x = first_x; x < columns; ++x)
            if (flux[face_index(x, y)] != 0) return true;
    return false;
}

TileBlock<std::int32_t> apply_fluxes(const TileScratch& scratch, int columns, int rows) {
    TileBlock<std::int32_t> block = TileBlock<std::int32_t>::uninitialised();
    core::kernels<TileKernels>().apply_fluxes(scratch, block.write());
    clear_beyond(block.write(), columns, rows);
    return block;
}

/// How far apart two thicknesses of a tile are, anywhere and within a halo's width of each side.
TileMotion motion_between(const std::int32_t* before, const std::int32_t* after, int columns, int rows) {
    ColumnChanges changes;
    const auto largest = [&](int first, int last) {
        return thickness_mm(
            *std::max_element(changes.begin() + std::max(first, 0), changes.begin() + last));
    };
    TileMotion motion;
    core::kernels<TileKernels>().largest_changes(before, after, 0, rows, changes);
    motion.largest_mm = largest(0, columns);
    motion.near_side_mm[kLeft] = largest(0, std::min(kHalo, columns));
    motion.near_side_mm[kRight] = largest(columns - kHalo, columns);
    core::kernels<TileKernels>().largest_changes(before, after, 0, std::min(kHalo, rows), changes);
    motion.near_side_mm[kTop] = largest(0, columns);
    core::kernels<TileKernels>().largest_changes(before, after, std::max(rows - kHalo, 0), rows,
                                                 changes);
    motion.near_side_mm[kBottom] = largest(0, columns);
    return motion;
}

SideSpeeds side_speeds(const TileScratch& scratch, int columns, int rows) {
    SideSpeeds speeds{};
    const auto add = [&](Side side, float velocity) {
        speeds[side] = std::max(speeds[side], std::abs(velocity));
    };
    for (const int depth : {0, 1}) {
        for (int y = 0; y < rows; ++y) {
            add(kLeft, scratch.velocity_x[face_index(depth - 1, y)]);
            add(kRight, scratch.velocity_x[face_index(columns - 1 - depth, y)]);
        }
        for (int x = 0; x < columns; ++x) {
            add(kTop, scratch.velocity_y[face_index(x, depth - 1)]);
            add(kBottom, scratch.velocity_y[face_index(x, rows - 1 - depth)]);
        }
    }
    return speeds;
}

TileBlock<float> velocity_block(const FaceArray<float>& velocity) {
    TileBlock<float> block = TileBlock<float>::uninitialised();
    float* out = block.write();
    for (int y = 0; y < kTileSize; ++y)
        std::copy_n(&velocity[face_index(0, y)], kTileSize, out + y * kTileSize);
    return block;
}

/// The old velocities but for those of the faces at the tile's right and lower edge, where they are
/// open.
void take_edge_velocities(const FilmState& state, const TilePlace& place, const TileScratch& scratch,
                          TileResult& result) {
    const int right = place.columns.extent - 1, bottom = place.rows.extent - 1;
    if (!place.closed.right) {
        result.velocity_x = TileBlock<float>::copy_of(state.velocity_x.read(place.tile));
        float* velocity = result.velocity_x.write();
        for (int y = 0; y <= bottom; ++y)
            velocity[y * kTileSize + right] = scratch.velocity_x[face_index(right, y)];
    }
    if (!place.closed.bottom) {
        result.velocity_y = TileBlock<float>::copy_of(state.velocity_y.read(place.tile));
        std::copy_n(&scratch.velocity_y[face_index(0, bottom)], right + 1,
                    result.velocity_y.write() + bottom * kTileSize);
    }
}

std::int64_t thickness_runoff(const TileScratch& scratch, int columns, int rows, const OpenEdges& open) {
    std::int64_t runoff = 0;
    for (int y = 0; y < rows; ++y) {
        if (open.left) runoff -= scratch.flux_x[face_index(-1, y)];
        if (open.right) runoff += scratch.flux_x[face_index(columns - 1, y)];
    }
    for (int x = 0; x < columns; ++x) {
        if (open.top) runoff -= scratch.flux_y[face_index(x, -1)];
        if (open.bottom) runoff += scratch.flux_y[face_index(x, rows - 1)];
    }
    return runoff;
}

void move_pigment(const FilmState& state, const TilePlace& place, WorkerScratch& worker,
                  TileResult& result) {
    Concentrations concentrations{worker.concentrations.data()};
    gather_concentrations(state, place.columns, place.rows, place.tile_x, concentrations);
    const bool crowded = concentrations.largest > kCrowded;
    if (crowded) gather_held(state, place.columns, place.rows, worker.held);
    result.paint = new_paint(place);
    note_moved(core::kernels<TileKernels>().transport(
                   worker.tile, worker.concentrations.data(), crowded ? worker.held.data() : nullptr,
                   place.columns.extent, place.rows.extent, place.runoff_edges,
                   state.paint.read(place.tile), result.paint.write()),
               result);
}

/// Lowers what a cell holds of other media to what it holds of paint.
void keep_within(const std::int32_t* thickness, MediaCell* cells) {
    for (int cell = 0; cell < grid::kTileCells; ++cell) {
        std::int32_t left = thickness[cell];
        for (std::int32_t& amount : cells[cell]) {
            amount = std::clamp(amount, 0, left);
            left -= amount;
        }
    }
}

/// Where each medium goes, by the same law as pigment.
TileBlock<MediaCell> moved_media(const FilmState& state, const TilePlace& place,
                                 const std::int32_t* thickness_after, WorkerScratch& worker) {
    if (!gather_media(state, place.columns, place.rows, place.tile, worker.concentrations.data()))
        return {};
    TileBlock<MediaCell> cells = new_paint(place);
    core::kernels<TileKernels>().transport(worker.tile, worker.concentrations.data(), nullptr,
                                           place.columns.extent, place.rows.extent, place.runoff_edges,
                                           state.media.foreign.read(place.tile), cells.write());
    keep_within(thickness_after, cells.write());
    return cells;
}

/// Gives each medium's paint its own density, where all have had the step's.
void weigh_media(const StepConstants& step, HaloBlock& block) {
    const float density_kg_m3 = 1e6F / step.yield_per_Pa;
    for (int i = 0; i < kBlockCells; ++i) {
        const float lighter = density_kg_m3 / block.numbers.density_kg_m3[i];
        block.yield[i] *= lighter;
        if (block.pressed) block.air[i] *= lighter;
    }
}

/// Viscosity and yield stress of every cell, after gather().
void gather_rheology(const FilmState& state, const TilePlace& place, const StepConstants& step,
                     WorkerScratch& worker) {
    const auto& kernels = core::kernels<TileKernels>();
    HaloBlock& block = worker.tile.block;
    if (step.mixed) {
        gather_rheology(state, place.columns, place.rows, place.tile_x, step.yield_per_Pa,
                        kernels.rheology, block);
    } else {
        block.viscosity.fill(step.viscosity_mm2_s);
        block.yield.fill(step.yield);
    }
    if (!gather_worked(state, place, worker.structure->quanta)) return;
    gather_number(state, place.columns, place.rows, place.tile_x, &FilmNumbers::structure_share,
                  step.structure_share, step, worker.structure->structure_share);
    kernels.loosen(worker.structure->quanta.data(), block.quanta.data(), kBlockCells,
                   worker.structure->structure_share.data(), block.viscosity.data(), block.yield.data());
}

/// The drag is 6 / (3 alpha - 1).
FilmProfile profile_of(const StepConstants& step) {
    const float width = 6.0F / step.drag_along;
    return {(width + 1.0F) / 3.0F, width};
}

void move_paint(const FilmState& state, const TilePlace& place, const StepConstants& step,
                WorkerScratch& worker, TileResult& result) {
    const int columns = place.columns.extent, rows = place.rows.extent;
    result.thickness = apply_fluxes(worker.tile, columns, rows);
    result.motion = motion_between(place.motion_reference, result.thickness.read(), columns, rows);
    result.runoff.thickness = thickness_runoff(worker.tile, columns, rows, place.runoff_edges);
    const FilmProfile profile = profile_of(step);
    if (state.worked.is_followed)
        result.worked = moved_structure(state, place, step, profile, result.thickness.read(), worker);
    if (state.media.are_several())
        result.media = moved_media(state, place, result.thickness.read(), worker);
    if (gather_strata(state, place, worker.tile.block, *worker.strata))
        move_strata(state, place, profile, worker, result);
    else if (place.pigment_in_reach)
        move_pigment(state, place, worker, result);
}

}  // namespace

void clear_beyond(std::int32_t* values, int columns, int rows) {
    for (int y = 0; y < kTileSize; ++y) {
        const int first = y < rows ? columns : 0;
        std::fill(values + y * kTileSize + first, values + (y + 1) * kTileSize, 0);
    }
}

TileBlock<PaintCell> new_paint(const TilePlace& place) {
    const bool whole = place.columns.extent == kTileSize && place.rows.extent == kTileSize;
    return whole ? TileBlock<PaintCell>::uninitialised() : TileBlock<PaintCell>::filled({});
}

void note_moved(const PigmentMoved& moved, TileResult& result) {
    for (int k = 0; k < kPaintChannels; ++k)
        result.runoff.paint[k] += moved.runoff[k];
    result.extremes.clamped_faces += moved.held_back_faces;
}

TileResult collect_tile(const FilmState& state, const TilePlace& place, const StepConstants& step,
                        const FlowExtremes& extremes, WorkerScratch& worker) {
    const int columns = place.columns.extent, rows = place.rows.extent;
    TileResult result;
    result.extremes = extremes;
    result.side_speeds_mm_s = side_speeds(worker.tile, columns, rows);
    if (place.closed.inside) {
        take_edge_velocities(state, place, worker.tile, result);
    } else if (extremes.speed_mm_s > 0.0F || !state.velocity_x.is_background(place.tile)) {
        result.velocity_x = velocity_block(worker.tile.velocity_x);
        result.velocity_y = velocity_block(worker.tile.velocity_y);
    }
    if (any_flux(worker.tile.flux_x, -1, 0, columns, rows) ||
        any_flux(worker.tile.flux_y, 0, -1, columns, rows))
        move_paint(state, place, step, worker, result);
    return result;
}

void gather_tile(const FilmState& state, const TilePlace& place, const StepConstants& step,
                 WorkerScratch& worker) {
    gather(state, place.columns, place.rows, place.tile_x, step.wet_mm, worker.tile.block);
    gather_covered(place.cover, place.columns, place.rows, place.tile_x, worker.tile.block);
    if (step.media) gather_numbers(state, place.columns, place.rows, place.tile_x, worker.tile.block);
    if (step.varied) gather_rheology(state, place, step, worker);
    press(place.air, place.density_kg_m3, place.columns, place.rows, step.cell_mm, worker.tile.block);
    if (step.media) weigh_media(step, worker.tile.block);
}

TileResult update_tile(const FilmState& state, const TilePlace& place, const StepConstants& step,
                       WorkerScratch& worker) {
    gather_tile(state, place, step, worker);
    worker.tile.large_fluxes = false;
    const FlowExtremes extremes = core::kernels<TileKernels>().flow(
        step, place.columns.extent, place.rows.extent, place.closed, worker.tile);
    return collect_tile(state, place, step, extremes, worker);
}

}  // namespace pastoso::film
