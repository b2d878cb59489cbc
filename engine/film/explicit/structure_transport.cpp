#include "film/explicit/structure_transport.hpp"

#include "film/explicit/numbers_block.hpp"

namespace pastoso::film {

namespace {

/// What of the step concerns structure.
StructureStep structure_step(const StepConstants& step, const FilmProfile& profile) {
    const float shear = (6.0F * profile.alpha - 3.0F) / profile.width;
    const auto cell_quanta = static_cast<float>(step.cell_mm / kThicknessQuantum_mm);
    return {cell_quanta * shear};
}

}  // namespace

bool gather_worked(const FilmState& state, const TilePlace& place, BlockArray<std::int32_t>& worked) {
    const auto is_in = [&](int tile) { return state.worked.is_in(tile); };
    if (!any_tile_near(place, state.shape.tiles_x(), is_in)) return false;
    gather_quanta(state.worked.thickness, place.columns, place.rows, place.tile_x, worked);
    return true;
}

grid::TileBlock<std::int32_t> moved_structure(const FilmState& state, const TilePlace& place,
                                              const StepConstants& step, const FilmProfile& profile,
                                              const std::int32_t* thickness_after,
                                              WorkerScratch& worker) {
    StructureScratch& structure = *worker.structure;
    if (!gather_worked(state, place, structure.quanta)) structure.quanta.fill(0);
    gather_number(state, place.columns, place.rows, place.tile_x, &FilmNumbers::breakdown_strain,
                  step.breakdown_strain, step, structure.breakdown_strain);
    auto block = grid::TileBlock<std::int32_t>::uninitialised();
    core::kernels<TileKernels>().move_structure(structure_step(step, profile), worker.tile, structure,
                                                thickness_after, block.write());
    clear_beyond(block.write(), place.columns.extent, place.rows.extent);
    return block;
}

}  // namespace pastoso::film
