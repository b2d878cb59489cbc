// The subcommand "info": about a file, or about the program itself.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Prints to the output stream. Throws InputError when the file cannot be read.
void run_info(const InfoOptions& options);

}  // namespace pastoso::cli
