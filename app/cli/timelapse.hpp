// The subcommand "timelapse": a recording, or the strokes of a painting, as a film.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Writes frame-00001.png and so on into a folder, those that are missing, or a video. Throws InputError
/// or UsageError before any file is changed where the request cannot be met, and Interrupted when the
/// user stops it: a folder then keeps its frames, and the same command goes on with it.
void run_timelapse(const TimelapseOptions& options);

}  // namespace pastoso::cli
