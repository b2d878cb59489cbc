// The kernels of a tile's step, as the instruction set's own sources call one another.
#pragma once

#include "film/explicit/tile_step.hpp"

namespace pastoso::film::PASTOSO_ISA {

void prepare_pressure(const StepConstants& step, TileScratch& scratch);
FlowExtremes tile_flow(const StepConstants& step, int columns, int rows, const ClosedFaces& closed,
                       TileScratch& scratch);
PigmentMoved transport_pigment(const TileScratch& scratch, const float* concentrations,
                               const PaintCell* held, int columns, int rows,
                               const OpenEdges& runoff_edges, const PaintCell* before, PaintCell* after);
std::int32_t concentrate(const PaintCell* pigment, const std::int32_t* thickness, int count, float* out);
void find_read_cells(const TileScratch& scratch, int columns, int rows, StrataScratch& strata);
std::int32_t concentrate_strata(const WetStrataCells& cells, const std::uint8_t* read, int count,
                                float* lower, float* upper);
void split_strata(const FilmProfile& profile, float cell_quanta, TileScratch& scratch,
                  StrataScratch& upper);
StrataMoved transport_strata(const TileScratch& scratch, const StrataScratch& upper, int columns,
                             int rows, const OpenEdges& runoff_edges, const StrataPaint& paint);
void cell_rheology(const PaintCell* paint, const std::int32_t* thickness, int count, float yield_per_Pa,
                   float* viscosity, float* yield);
void loosen(const std::int32_t* worked, const std::int32_t* thickness, int count,
            const float* structure_share, float* viscosity, float* yield);
void move_structure(const StructureStep& step, const TileScratch& scratch, StructureScratch& structure,
                    const std::int32_t* thickness_after, std::int32_t* worked_after);
void apply_fluxes(const TileScratch& scratch, std::int32_t* after);
void largest_changes(const std::int32_t* before, const std::int32_t* after, int first_row, int last_row,
                     ColumnChanges& changes);

}  // namespace pastoso::film::PASTOSO_ISA
