#include "cli/thumbnail.hpp"

#include "core/text_file.hpp"
#include "project/project.hpp"

namespace pastoso::cli {

/// Silent, and a PNG file whatever its name is: file managers name it as they like.
void run_thumbnail(const ThumbnailOptions& options) {
    core::write_text_file(options.output, project::load_thumbnail(options.project, options.longest_px));
}

}  // namespace pastoso::cli
