// The figures that runs of liquids have in common, for people and for measuring scripts.
#pragma once

#include "liquid_files/frame_costs.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pastoso::liquid_files {

struct RunStats {
    double wall_s = 0.0;      ///< from the start of the program's work to the last file written
    double simulate_s = 0.0;  ///< of that: the flow and what it carries
    FrameCosts files;         ///< of that as well; io_s has all that is kept too
    std::int64_t steps = 0;
    int pcg_iterations_max = 0;      ///< of all solutions of the pressure
    std::int64_t not_converged = 0;  ///< steps whose pressure missed its tolerance
    std::uint64_t state_hash = 0;    ///< of the liquid at the end
    int threads = 0;
    std::string version;
};

/// A figure of one kind of run.
using Figure = std::pair<const char*, std::variant<std::int64_t, double>>;

/// One flat JSON object of numbers and texts, written aside; with steps_per_s = steps / simulate_s.
/// Throws InputError when it cannot be written.
void write_run_stats(const std::filesystem::path& path, const RunStats& stats,
                     const std::vector<Figure>& own);

}  // namespace pastoso::liquid_files
