// "tea --classic": the system of 2010, as it was or on today's solver.
#pragma once

#include "cli/options.hpp"
#include "core/thread_pool.hpp"
#include "liquid_files/tea_stats.hpp"

namespace pastoso::cli {

/// Writes its surfaces, metaballs of the source's kernel and threshold, and measures how its particles
/// pile up. Throws UsageError for what it has not: a scene, a cache, pictures.
liquid_files::TeaStats run_classic_tea(const TeaOptions& options, int frame_count,
                                       core::ThreadPool& pool);

}  // namespace pastoso::cli
