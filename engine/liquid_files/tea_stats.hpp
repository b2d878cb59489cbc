// The figures of a run of milk tea.
#pragma once

#include "liquid/tea/milk_tea.hpp"
#include "liquid_files/run_stats.hpp"

#include <cstdint>

namespace pastoso::liquid_files {

struct TeaStats : RunStats {
    std::int64_t parcels = 0, balls = 0;  ///< at the end
    double milk_error_rel = 0.0;          ///< milk there is against milk that was poured, at the end
    double divergence_max = 0.0;          ///< 1/s, of all steps
    /// Of the classic system, by voxels of its own lattice (liquid::PileUp); 0 otherwise.
    double pile_up_dispersion = 0.0, pile_up_at_borders = 0.0;
};

/// Of parcels, dissolved milk and coldness; equal teas give equal hashes.
std::uint64_t state_hash(const liquid::MilkTea& tea);

/// See write_run_stats().
void write_stats(const std::filesystem::path& path, const TeaStats& stats);

}  // namespace pastoso::liquid_files
