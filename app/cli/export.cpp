#include "cli/export.hpp"

#include "cli/interrupt.hpp"
#include "cli/printing.hpp"
#include "cli/progress.hpp"
#include "cli/usage_error.hpp"
#include "core/looking.hpp"
#include "core/memory.hpp"
#include "core/number_text.hpp"
#include "core/thread_pool.hpp"
#include "document/canvas.hpp"
#include "files/file_access.hpp"
#include "project/layered_copy.hpp"
#include "project/repainting.hpp"
#include "recordings/painting_export.hpp"
#include "recordings/relief_export.hpp"

#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pastoso::cli {
namespace {

using core::number_text;

recordings::ExportKind kind_of(const ExportOptions& options) {
    if (recordings::is_relief_path(options.output)) return recordings::ExportKind::Relief;
    if (options.maps) return recordings::ExportKind::Maps;
    return options.layers ? recordings::ExportKind::Layers : recordings::ExportKind::Picture;
}

bool is_painting(const ExportOptions& options) {
    return project::is_project_path(options.output);
}

bool is_copy(const ExportOptions& options) {
    return project::is_layered_copy_path(options.output);
}

/// What the output is called that --layers and --maps are not for; empty: a picture.
std::string other_kind(const ExportOptions& options) {
    if (is_painting(options)) return "a painting";
    if (is_copy(options)) return "a copy in layers";
    return recordings::is_relief_path(options.output) ? "a relief" : "";
}

void check_usage(const ExportOptions& options) {
    if (options.output.empty() && options.well.empty())
        throw UsageError("export needs a picture to make: -o FILE, or --well FILE.");
    if (options.output.empty() && (options.layers || options.maps))
        throw UsageError("--layers and --maps need a file to make: -o FILE.");
    if (options.layers && options.maps) throw UsageError("--layers and --maps exclude each other.");
    if (is_painting(options) && core::absolute_path(options.output).lexically_normal() ==
                                    core::absolute_path(options.project).lexically_normal())
        throw UsageError(options.output + ": is the painting itself; name another file.");
    if (is_painting(options) && !options.again_px_per_mm)
        throw UsageError(options.output +
                         ": a painting is made by painting it again: --again PX_PER_MM.");
    if (!other_kind(options).empty() && (options.layers || options.maps))
        throw UsageError("--layers and --maps are for pictures; " + options.output + " is " +
                         other_kind(options) + ".");
    if (is_copy(options) && (options.flat || options.scale != 1.0))
        throw UsageError("--flat and --scale are not for copies in layers such as " + options.output +
                         ".");
}

/// What is wanted of the canvas and of the mixing well.
std::vector<recordings::ExportChoice> choices_of(const ExportOptions& options) {
    recordings::ExportChoice choice;
    choice.lit = !options.flat;
    choice.scale = options.scale;
    choice.picture = options.picture;
    choice.relief = {options.base_mm, options.exaggeration, options.resolution_mm};
    std::vector<recordings::ExportChoice> choices;
    if (!options.output.empty() && !is_painting(options) && !is_copy(options)) {
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

void tell(const recordings::ExportChoice& choice, const recordings::ExportReport& report) {
    if (choice.kind == recordings::ExportKind::Relief) {
        print("%s: %zu triangles, %s x %s mm\n", choice.path.c_str(), report.triangles,
              number_text(report.width_mm).c_str(), number_text(report.height_mm).c_str());
        return;
    }
    for (const auto& file : report.files)
        print("%s: %d x %d pixels\n", file.c_str(), report.width_px, report.height_px);
    if (choice.kind == recordings::ExportKind::Maps)
        print("heights: %s mm (black) to %s mm (white) on a canvas %s mm wide\n",
              number_text(report.heights.black_mm).c_str(), number_text(report.heights.white_mm).c_str(),
              number_text(report.width_mm).c_str());
}

/// Throws Interrupted where the export was stopped.
void write(const document::PaintingState& painting, const recordings::ExportChoice& choice,
           core::ThreadPool& pool, bool quiet) {
    Progress progress("writing " + choice.path.string(), Progress::style_for_stderr(quiet));
    const recordings::ExportReport report =
        recordings::export_painting(painting, choice, pool, [&](double done) {
            progress.update(done);
            return !is_interrupted();
        });
    if (report.status == files::ExportStatus::Stopped) throw Interrupted{};
    progress.clear();
    tell(choice, report);
}

void write_copy(const document::PaintingState& painting, const ExportOptions& options,
                core::ThreadPool& pool) {
    Progress progress("writing " + options.output, Progress::style_for_stderr(options.quiet));
    const project::LayeredCopyReport report =
        project::save_layered_copy({options.output}, painting, pool, [&](double done) {
            progress.update(done);
            return !is_interrupted();
        });
    if (report.status == files::ExportStatus::Stopped) throw Interrupted{};
    progress.clear();
    print("%s: %d x %d pixels, layers: %zu\n", options.output.c_str(), report.width_px, report.height_px,
          report.layers);
}

project::Project loaded(const ExportOptions& options, core::ThreadPool& pool) {
    project::LoadedProject project = project::load_project(options.project, pool);
    for (const core::Message& note : project.notes)
        complain(note.text());
    return project;
}

/// The strokes on the cells that are wanted. Says what should be known before they are painted, and
/// throws InputError for choices that cannot be made of them.
document::Recording strokes_again(const ExportOptions& options,
                                  const std::vector<recordings::ExportChoice>& choices) {
    std::vector<core::Message> notes;
    document::Recording strokes = project::load_strokes(options.project, notes);
    if (strokes.events.empty())
        for (const core::Message& note : notes)
            complain(note.text());
    strokes.canvas.px_per_mm = *options.again_px_per_mm;
    const project::RepaintingTerms terms =
        project::repainting_terms(strokes, options.project, core::available_memory_bytes());
    for (const recordings::ExportChoice& choice : choices)
        recordings::export_size({terms.cells, 1.0 / strokes.canvas.px_per_mm}, choice);
    for (const core::Message& note : terms.notes)
        complain(options.project + ": " + note.text());
    if (!options.quiet)
        print("painting %d x %d cells, which takes about %zu MiB of memory\n", terms.cells.width,
              terms.cells.height, terms.memory_bytes >> 20);
    return strokes;
}

/// Throws Interrupted where it was stopped.
project::Project painted_again(const ExportOptions& options,
                               const std::vector<recordings::ExportChoice>& choices,
                               core::ThreadPool& pool) {
    const document::Recording strokes = strokes_again(options, choices);
    Progress progress("painting", Progress::style_for_stderr(options.quiet));
    std::optional<project::Project> painted =
        project::repaint(strokes, options.project, pool, [&](double done) {
            progress.update(done);
            return !is_interrupted();
        });
    if (!painted) throw Interrupted{};
    return *std::move(painted);
}

void save(const project::Project& painted, const ExportOptions& options, core::ThreadPool& pool) {
    project::save_project(options.output, painted, pool);
    const grid::Shape cells = document::canvas_shape(painted.painting.value.bare->settings);
    print("%s: the painting in %d x %d cells\n", options.output.c_str(), cells.width, cells.height);
}

}  // namespace

void run_export(const ExportOptions& options) {
    watch_for_interrupts();
    check_usage(options);
    const std::vector<recordings::ExportChoice> choices = choices_of(options);
    for (const recordings::ExportChoice& choice : choices)
        recordings::check_export(choice);
    if (is_painting(options)) files::check_writable(options.output);
    if (is_copy(options)) project::check_layered_copy({options.output});
    core::ThreadPool pool(options.threads);
    const project::Project project =
        options.again_px_per_mm ? painted_again(options, choices, pool) : loaded(options, pool);
    if (is_painting(options)) save(project, options, pool);
    if (is_copy(options)) write_copy(project.painting, options, pool);
    for (const recordings::ExportChoice& choice : choices)
        write(project.painting, choice, pool, options.quiet);
}

}  // namespace pastoso::cli
