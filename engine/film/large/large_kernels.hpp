// The kernels of a large step, as the instruction set's own sources call one another.
#pragma once

#include "film/large/large_tile_kernels.hpp"

namespace pastoso::film::PASTOSO_ISA {

float assemble_large_tile(const StepConstants& step, int columns, int rows, const ClosedFaces& closed,
                          const CanvasEdges& edges, bool again, LargeScratch& large,
                          TileScratch& scratch, LargeTile& tile);
float refine_yielding(const StepConstants& step, const LargeScratch& large, LargeTile& tile);
void compute_source(const StepConstants& step, LargeTile& tile);
void slow_limited_faces(const StepConstants& step, const LargeScratch& large, LargeTile& tile);
void prepare_multigrid(const StepConstants& step, const grid::Rect& within, LargeScratch& scratch);
void multigrid_cycle(const StepConstants& step, LargeScratch& scratch);
void compute_change(const LargeScratch& large, LargeTile& tile);
float compute_residual(const StepConstants& step, int columns, int rows, const std::int32_t* thickness,
                    const LargeScratch& large, LargeTile& tile);
void correct_patch(const StepConstants& step, int cycles, const grid::Rect& within,
                   LargeScratch& scratch, PatchArray& correction);
void blend_corrections(const PatchCover* covers, int count, CellArray& pressure);
void compute_large_velocities(const StepConstants& step, bool carrying, const LargeScratch& scratch,
                           LargeTile& tile);
int cut_to_capacity(const StepConstants& step, const LargeScratch& scratch, LargeTile& tile);
Shortage share_outflow(const StepConstants& step, int columns, int rows, const std::int32_t* thickness,
                       const LargeScratch& scratch, LargeTile& tile, CellArray& share);
FlowExtremes compute_large_fluxes(const StepConstants& step, const LargeScratch& large,
                               const LargeTile& tile, TileScratch& scratch);

}  // namespace pastoso::film::PASTOSO_ISA
