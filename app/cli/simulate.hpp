// The subcommand "simulate": runs a film scene without a brush and writes what is measured and seen.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Throws InputError before any file is changed where the request cannot be met, and Interrupted when
/// the user stops it.
void run_simulate(const SimulateOptions& options);

}  // namespace pastoso::cli
