// The kernels of a large step for the machine's instruction set.
#pragma once

#include "core/kernels.hpp"
#include "film/large/large_tile.hpp"

namespace pastoso::film {

struct LargeKernels {
    /// The faces but for their velocities, source, starting pressure and the change that it makes, from
    /// the gathered block of `scratch` and the lagged pressure of `large`. `again` says that the tile
    /// holds a solution of this step, whose pressure the lagged one is: shear-thinning paint is thinned
    /// by its velocities, and the pressure and its change stay as they are. Returned is then by what
    /// part a flux of that solution was wrong.
    float (*assemble)(const StepConstants& step, int columns, int rows, const ClosedFaces& closed,
                      const CanvasEdges& edges, bool again, LargeScratch& large, TileScratch& scratch,
                      LargeTile& tile);
    /// Newton's step for the drag of yielding paint: star, mobility and source from the gathered
    /// pressure. Returns by what part a flux was wrong.
    float (*refine)(const StepConstants& step, const LargeScratch& large, LargeTile& tile);
    /// f = -(dt/dx) div(h_f u*)
    void (*compute_source)(const StepConstants& step, LargeTile& tile);
    /// d = f - A p from the gathered pressure.
    void (*compute_change)(const LargeScratch& large, LargeTile& tile);
    /// The residual Pi + S d - p from the gathered change. Returns the largest error of thickness that
    /// it stands for, relative to the film or two cells of it.
    float (*compute_residual)(const StepConstants& step, int columns, int rows,
                              const std::int32_t* thickness, const LargeScratch& large, LargeTile& tile);
    /// The correction of the patch's pressure that removes the gathered residual, by that many V-cycles.
    /// `within` holds the cells of the patch within the canvas' open edges.
    void (*correct_patch)(const StepConstants& step, int cycles, const grid::Rect& within,
                          LargeScratch& scratch, PatchArray& correction);
    /// Adds the corrections of all patches that cover a tile, each with a weight that falls smoothly to
    /// nothing towards its patch's edge: where patches meet, no kink is left, which surface tension
    /// would resent.
    void (*blend)(const PatchCover* covers, int count, CellArray& pressure);
    /// u = u* - D dt grad p; `carrying` makes of it the velocity that moves the paint.
    void (*velocities)(const StepConstants& step, bool carrying, const LargeScratch& scratch,
                       LargeTile& tile);
    /// Cuts velocities that would fill the cell ahead by more than a quarter of its capacity left.
    /// Returns at how many faces. Where both cells hold less than kCrowded_quanta nothing is cut.
    int (*cut_to_capacity)(const StepConstants& step, const LargeScratch& scratch, LargeTile& tile);
    /// The share of each cell's outflow that it can give: what it holds and what its neighbours are
    /// granted to give it. Into `share`.
    Shortage (*share_outflow)(const StepConstants& step, int columns, int rows,
                              const std::int32_t* thickness, const LargeScratch& scratch,
                              LargeTile& tile, CellArray& share);
    /// Multiplies star and mobility of each face by the share that its donor cell grants.
    void (*slow_limited_faces)(const StepConstants& step, const LargeScratch& large, LargeTile& tile);
    /// Velocities and whole quanta of flux, into `scratch`.
    FlowExtremes (*fluxes)(const StepConstants& step, const LargeScratch& large, const LargeTile& tile,
                           TileScratch& scratch);

    static const LargeKernels baseline, avx2, avx512;
};

}  // namespace pastoso::film
