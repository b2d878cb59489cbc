// The subcommand "replay": paints a recording, lets it run, renders it.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Throws InputError or UsageError before any file is changed where the request cannot be met, and
/// Interrupted when the user stops it.
void run_replay(const ReplayOptions& options);

/// The same with the recording of the reference sheet, which comes with the program.
void run_sheet(ReplayOptions options);

}  // namespace pastoso::cli
