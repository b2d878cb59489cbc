// The subcommand "export": pictures of a project file.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Throws InputError when the project cannot be read or a picture cannot be written, UsageError when no
/// picture is asked for.
void run_export(const ExportOptions& options);

}  // namespace pastoso::cli
