#include "cli/export.hpp"

#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/usage_error.hpp"
#include "core/thread_pool.hpp"
#include "document/number_text.hpp"
#include "io/painting_export.hpp"
#include "io/relief_export.hpp"
#include "project/project.hpp"

#include <cstdio>
#include <string>
#include <vector>

namespace pastoso::cli {
namespace {

using document::number_text;

io::ExportKind kind_of(const ExportOptions& options) {
    if (io::is_relief_path(options.output)) return io::ExportKind::Relief;
    if (options.maps) return io::ExportKind::Maps;
    return options.layers ? io::ExportKind::Layers : io::ExportKind::Picture;
}

void check_usage(const ExportOptions& options) {
    if (options.output.empty() && options.well.empty())
        throw UsageError("export needs a picture to make: -o FILE, or --well FILE.");
    if (options.output.empty() && (options.layers || options.maps))
        throw UsageError("--layers and --maps need a file to make: -o FILE.");
    if (options.layers && options.maps) throw UsageError("--layers and --maps exclude each other.");
    if (!options.output.empty() && io::is_relief_path(options.output) &&
        (options.layers || options.maps))
        throw UsageError("--layers and --maps are for pictures; " + options.output + " is a relief.");
}

/// What is wanted of the canvas and of the mixing well.
std::vector<io::ExportChoice> choices_of(const ExportOptions& options) {
    io::ExportChoice choice;
    choice.lit = !options.flat;
    choice.scale = options.scale;
    choice.picture = options.picture;
    choice.relief = {options.base_mm, options.exaggeration, options.resolution_mm};
    std::vector<io::ExportChoice> choices;
    if (!options.output.empty()) {
        choices.push_back(choice);
        choices.back().kind = kind_of(options);
        choices.back().path = options.output;
    }
    if (!options.well.empty()) {
        choices.push_back(choice);
        choices.back().of_well = true;
        choices.back().path = options.well;
    }
    return choices;
}

void print(const io::ExportChoice& choice, const io::ExportReport& report) {
    if (choice.kind == io::ExportKind::Relief) {
        std::printf("%s: %zu triangles, %s x %s mm\n", choice.path.c_str(), report.triangles,
                    number_text(report.width_mm).c_str(), number_text(report.height_mm).c_str());
        return;
    }
    for (const auto& file : report.files)
        std::printf("%s: %d x %d pixels\n", file.c_str(), report.width_px, report.height_px);
    if (choice.kind == io::ExportKind::Maps)
        std::printf("heights: %s mm (black) to %s mm (white) on a canvas %s mm wide\n",
                    number_text(report.heights.black_mm).c_str(),
                    number_text(report.heights.white_mm).c_str(), number_text(report.width_mm).c_str());
}

/// Throws Interrupted where the export was stopped.
void write(const document::PaintingState& painting, const io::ExportChoice& choice,
           core::ThreadPool& pool, bool quiet) {
    Progress progress("writing " + choice.path.string(), Progress::style_for_stderr(quiet));
    const io::ExportReport report = io::export_painting(painting, choice, pool, [&](double done) {
        progress.update(done);
        return !is_interrupted();
    });
    if (report.status == io::ExportStatus::Stopped) throw Interrupted{};
    progress.clear();
    print(choice, report);
}

}  // namespace

void run_export(const ExportOptions& options) {
    watch_for_interrupts();
    check_usage(options);
    const std::vector<io::ExportChoice> choices = choices_of(options);
    for (const io::ExportChoice& choice : choices)
        io::check_export(choice);
    core::ThreadPool pool(options.threads);
    const project::LoadedProject project = project::load_project(options.project, pool);
    for (const std::string& note : project.notes)
        std::fprintf(stderr, "pastoso-cli: %s\n", note.c_str());
    for (const io::ExportChoice& choice : choices)
        write(project.painting, choice, pool, options.quiet);
}

}  // namespace pastoso::cli
