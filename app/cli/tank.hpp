// The subcommand "tank": lets liquid move in a glass tank, measures it and draws it.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Throws InputError before any file is changed where the request cannot be met, and Interrupted when
/// the user stops it; files that are complete stay, and the next run goes on with the others.
void run_tank(const TankOptions& options);

}  // namespace pastoso::cli
