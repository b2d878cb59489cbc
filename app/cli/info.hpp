// The subcommand "info": about a file, paints and colours, or the program itself.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Prints to the output stream. Throws InputError when a file cannot be read or a paint is unknown,
/// UsageError for too few or too many words.
void run_info(const InfoOptions& options);

}  // namespace pastoso::cli
