// The subcommand "tea": pours milk into tea, and draws it; "tea render" draws what was kept before.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Both throw InputError before any file is changed where the request cannot be met, and Interrupted
/// when the user stops it; files that are complete stay, and the next run goes on with the others.
void run_tea(const TeaOptions& options);
void run_tea_render(const TeaRenderOptions& options);

}  // namespace pastoso::cli
