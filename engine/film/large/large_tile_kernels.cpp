// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/large/large_kernels.hpp"

PASTOSO_REGISTER_KERNELS(pastoso::film, LargeKernels, assemble_large_tile, refine_yielding, compute_source,
                         compute_change, compute_residual, correct_patch, blend_corrections,
                         compute_large_velocities, cut_to_capacity, share_outflow, slow_limited_faces,
                         compute_large_fluxes)
