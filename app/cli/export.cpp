#include "cli/export.hpp"

#include "cli/interrupt.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "core/thread_pool.hpp"
#include "document/layered_canvas.hpp"
#include "document/number_text.hpp"
#include "document/well.hpp"
#include "io/files.hpp"
#include "io/map_export.hpp"
#include "io/picture_export.hpp"
#include "io/relief_export.hpp"
#include "project/project.hpp"

#include <cstdio>

namespace pastoso::cli {
namespace {

using document::number_text;

/// Of a document that has one layer.
constexpr const char* kLayer = "paint";

void check_output(const ExportOptions& options, const PictureStyle& style) {
    if (options.output.empty()) return;
    if (io::is_relief_path(options.output)) {
        if (options.layers || options.maps) {
            throw UsageError("--layers and --maps are for pictures; " + options.output +
                             " is a relief.");
        }
        io::check_writable(options.output);
    } else if (options.maps) {
        io::check_map_paths(options.output, style.encoding);
    } else {
        io::check_picture_path(options.output, style.encoding);
        if (options.layers && !io::is_linear_format(options.output))
            throw core::InputError(options.output + ": only .exr files hold --layers.");
    }
}

void check_request(const ExportOptions& options, const PictureStyle& style) {
    if (options.output.empty() && options.well.empty())
        throw UsageError("export needs a picture to make: -o FILE, or --well FILE.");
    if (options.output.empty() && (options.layers || options.maps))
        throw UsageError("--layers and --maps need a file to make: -o FILE.");
    if (options.layers && options.maps) throw UsageError("--layers and --maps exclude each other.");
    check_output(options, style);
    if (!options.well.empty()) io::check_picture_path(options.well, style.encoding);
}

/// One project's exports, with their progress.
class Exporter {
  public:
    Exporter(const ExportOptions& options, PictureStyle style, core::ThreadPool& pool)
        : options_(options), style_(std::move(style)), pool_(pool) {}

    void write_picture(const film::FilmState& film, const std::string& path) const {
        const io::ExportSource source = source_of(film);
        run(path, [&](const io::KeepGoing& keep_going) {
            return options_.layers && path == options_.output
                       ? io::export_layers(path, source, kLayer, pool_, keep_going)
                       : io::export_picture(path, source, style_.encoding, pool_, keep_going);
        });
        const shade::Lattice lattice = io::export_lattice(source);
        std::printf("%s: %d x %d pixels\n", path.c_str(), lattice.width, lattice.height);
    }

    void write_maps(const film::FilmState& film) const {
        const io::ExportSource source = source_of(film);
        io::MapHeights heights;
        run(options_.output, [&](const io::KeepGoing& keep_going) {
            return io::export_maps(options_.output, source, style_.encoding, pool_, keep_going,
                                   &heights);
        });
        const shade::Lattice lattice = io::export_lattice(source);
        for (const auto& path : io::map_paths(options_.output))
            std::printf("%s: %d x %d pixels\n", path.c_str(), lattice.width, lattice.height);
        std::printf("heights: %s mm (black) to %s mm (white) on a canvas %s mm wide\n",
                    number_text(heights.black_mm).c_str(), number_text(heights.white_mm).c_str(),
                    number_text(film.shape.width * film.cell_mm).c_str());
    }

    void write_relief(const film::FilmState& film) const {
        const io::Relief relief = io::relief_of(
            film, {options_.base_mm, options_.exaggeration, options_.resolution_mm}, pool_);
        run(options_.output, [&](const io::KeepGoing& keep_going) {
            return io::export_relief(options_.output, relief, keep_going);
        });
        std::printf("%s: %zu triangles, %s x %s mm\n", options_.output.c_str(), relief.triangle_count(),
                    number_text(film.shape.width * film.cell_mm).c_str(),
                    number_text(film.shape.height * film.cell_mm).c_str());
    }

  private:
    io::ExportSource source_of(const film::FilmState& film) const {
        shade::RenderSettings settings;
        settings.scale = options_.scale;
        settings.viewing = style_.viewing;
        return {film, document::kPrimedGround, settings};
    }

    /// Throws Interrupted where the export was stopped.
    template <class Export>
    void run(const std::string& path, const Export& work) const {
        Progress progress("writing " + path, Progress::style_for_stderr(options_.quiet));
        const io::ExportStatus status = work([&](double done) {
            progress.update(done);
            return !is_interrupted();
        });
        if (status == io::ExportStatus::Stopped) throw Interrupted{};
    }

    const ExportOptions& options_;
    PictureStyle style_;
    core::ThreadPool& pool_;
};

}  // namespace

void run_export(const ExportOptions& options) {
    watch_for_interrupts();
    const PictureStyle style = picture_style(options.picture);
    check_request(options, style);
    core::ThreadPool pool(options.threads);
    const project::LoadedProject project = project::load_project(options.project, pool);
    for (const std::string& note : project.notes)
        std::fprintf(stderr, "pastoso-cli: %s\n", note.c_str());
    const document::PaintingState& painting = project.painting;
    const film::FilmState canvas =
        document::view_of(painting.canvas.film, painting.bare_support_mm, painting.layers, pool);
    const Exporter exporter(options, style, pool);
    if (io::is_relief_path(options.output)) {
        exporter.write_relief(canvas);
    } else if (options.maps) {
        exporter.write_maps(canvas);
    } else if (!options.output.empty()) {
        exporter.write_picture(canvas, options.output);
    }
    if (!options.well.empty())
        exporter.write_picture(painting.well ? painting.well->film : document::bare_well(),
                               options.well);
}

}  // namespace pastoso::cli
