// The figures of a run of milk tea, for people and for measuring scripts.
#pragma once

#include "io/frame_costs.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace pastoso::io {

struct TeaStats {
    double wall_s = 0.0;      ///< from the start of the program's work to the last file written
    double simulate_s = 0.0;  ///< of that: the flow and what it carries
    FrameCosts files;         ///< of that as well; io_s has kept frames too
    std::int64_t steps = 0;
    std::int64_t parcels = 0, balls = 0;  ///< at the end
    double milk_error_rel = 0.0;          ///< milk there is against milk that was poured, at the end
    double divergence_max = 0.0;          ///< 1/s, of all steps
    int pcg_iterations_max = 0;           ///< of all solutions of the pressure
    std::int64_t not_converged = 0;       ///< steps whose pressure missed its tolerance
    /// Of the classic system, by voxels of its own lattice (liquid::PileUp); 0 otherwise.
    double pile_up_dispersion = 0.0, pile_up_at_borders = 0.0;
    std::uint64_t state_hash = 0;  ///< of parcels, dissolved milk and coldness at the end
    int threads = 0;
    std::string version;
};

/// One flat JSON object of numbers and texts, written aside; with steps_per_s = steps / simulate_s.
void write_stats(const std::filesystem::path& path, const TeaStats& stats);

}  // namespace pastoso::io
