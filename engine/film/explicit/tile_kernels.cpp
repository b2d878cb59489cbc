// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/tile_kernels.hpp"

PASTOSO_REGISTER_KERNELS(pastoso::film, TileKernels, tile_flow, transport_pigment, concentrate,
                         find_read_cells, concentrate_strata, split_strata, transport_strata,
                         apply_fluxes, largest_changes, cell_rheology, loosen, move_structure)
