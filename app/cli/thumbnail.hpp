// "pastoso-cli thumbnail": what file managers show of a painting.
#pragma once

#include "cli/options.hpp"

namespace pastoso::cli {

void run_thumbnail(const ThumbnailOptions& options);

}  // namespace pastoso::cli
