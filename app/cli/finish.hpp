// The end of a run of a liquid.
#pragma once

#include "cli/stopwatch.hpp"
#include "core/thread_pool.hpp"
#include "core/version.hpp"

#include <string>

namespace pastoso::cli {

/// Completes the figures of a run that began with the watch and writes them, where there is a path.
template <class Stats>
void finish(Stats& stats, const Stopwatch& watch, const core::ThreadPool& pool,
            const std::string& path) {
    stats.wall_s = watch.seconds();
    stats.threads = pool.thread_count();
    stats.version = core::version();
    if (!path.empty()) write_stats(path, stats);
}

}  // namespace pastoso::cli
