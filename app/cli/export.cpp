#include "cli/export.hpp"

#include "cli/picture.hpp"
#include "cli/usage_error.hpp"
#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "project/project.hpp"

#include <cstdio>

namespace pastoso::cli {
namespace {

void print_picture(const std::string& path, const PictureReport& picture) {
    std::printf("%s: %d x %d pixels\n", path.c_str(), picture.width_px, picture.height_px);
}

}  // namespace

void run_export(const ExportOptions& options) {
    if (options.output.empty() && options.well.empty())
        throw UsageError("export needs a picture to make: -o FILE, or --well FILE.");
    const PictureStyle style = picture_style(options.picture);
    for (const std::string& path : {options.output, options.well})
        if (!path.empty()) io::check_picture_path(path, style.encoding);
    core::ThreadPool pool(options.threads);
    const project::LoadedProject project = project::load_project(options.project, pool);
    for (const std::string& note : project.notes)
        std::fprintf(stderr, "pastoso-cli: %s\n", note.c_str());
    const document::Painting painting(project.painting, pool);
    PictureWriter pictures(painting.settings(), options.scale, style, pool);
    if (!options.output.empty()) print_picture(options.output, pictures.write(painting, options.output));
    if (!options.well.empty()) print_picture(options.well, pictures.write_well(painting, options.well));
}

}  // namespace pastoso::cli
