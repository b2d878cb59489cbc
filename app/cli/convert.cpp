#include "cli/convert.hpp"

#include "cli/export.hpp"
#include "cli/interrupt.hpp"
#include "cli/printing.hpp"
#include "cli/usage_error.hpp"
#include "core/number_text.hpp"
#include "core/thread_pool.hpp"
#include "document/canvas.hpp"
#include "files/file_access.hpp"
#include "project/import_open_raster.hpp"

namespace pastoso::cli {
namespace {

using core::number_text;

/// From a painting to a picture, as export does it.
ExportOptions export_options(const ConvertOptions& options) {
    ExportOptions wanted;
    wanted.project = options.source;
    wanted.output = options.output;
    wanted.scale = options.scale;
    wanted.picture = options.picture;
    wanted.threads = options.threads;
    wanted.quiet = options.quiet;
    return wanted;
}

project::ImportSettings import_settings(const ConvertOptions& options) {
    project::ImportSettings settings;
    if (options.as == "support") settings.as = project::ImportSettings::As::Support;
    settings.px_per_mm = options.px_per_mm;
    settings.width_mm = options.width_mm;
    settings.support = options.support;
    settings.support_relief_mm = options.relief_mm;
    return settings;
}

project::LoadedProject imported(const ConvertOptions& options, core::ThreadPool& pool) {
    const project::ImportSettings settings = import_settings(options);
    if (!project::is_open_raster_path(options.source))
        return project::import_picture(options.source, settings, pool);
    if (settings.as == project::ImportSettings::As::Support)
        throw UsageError("--as support takes a picture; " + options.source + " has layers.");
    return project::import_open_raster(options.source, settings, pool);
}

void print_canvas(const ConvertOptions& options, const document::PaintingState& painting) {
    const document::CanvasSettings& canvas = painting.value.bare->settings;
    const grid::Shape shape = document::canvas_shape(canvas);
    const std::size_t layers = painting.value.layers.layers.size();
    print("%s: %s x %s mm, %d x %d cells, %zu %s\n", options.output.c_str(),
          number_text(canvas.width_mm).c_str(), number_text(canvas.height_mm).c_str(), shape.width,
          shape.height, layers, layers == 1 ? "layer" : "layers");
}

}  // namespace

void run_convert(const ConvertOptions& options) {
    if (project::is_project_path(options.source)) {
        run_export(export_options(options));
        return;
    }
    if (!project::is_project_path(options.output))
        throw UsageError("a picture becomes a painting: name the second file NAME.pastoso.");
    watch_for_interrupts();
    files::check_writable(options.output);
    core::ThreadPool pool(options.threads);
    const project::LoadedProject project = imported(options, pool);
    for (const core::Message& note : project.notes)
        complain(note.text());
    stop_if_interrupted();
    project::save_project(options.output, project, pool);
    print_canvas(options, project.painting);
}

}  // namespace pastoso::cli
