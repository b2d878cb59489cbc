// The subcommand "validate": the film solver held against laws that others have derived or measured.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Throws InputError before anything runs where the request cannot be met, and Interrupted when the user
/// stops it.
void run_validate(const ValidateOptions& options);

}  // namespace pastoso::cli
