// The subcommand "recover": paintings that a program left unfinished.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Throws InputError when there is nothing to recover or a file cannot be written, UsageError when it is
/// not clear what to do.
void run_recover(const RecoverOptions& options);

}  // namespace pastoso::cli
