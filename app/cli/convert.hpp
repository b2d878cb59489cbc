// pastoso-cli convert: pictures onto canvases, and paintings into pictures.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

/// Throws UsageError and core::InputError.
void run_convert(const ConvertOptions& options);

}  // namespace pastoso::cli
