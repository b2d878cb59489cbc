#include "cli/replay.hpp"

#include "cli/interrupt.hpp"
#include "cli/picture.hpp"
#include "cli/printing.hpp"
#include "cli/progress.hpp"
#include "cli/recording_source.hpp"
#include "cli/stopwatch.hpp"
#include "core/error.hpp"
#include "core/naming.hpp"
#include "core/resources.hpp"
#include "core/thread_pool.hpp"
#include "core/version.hpp"
#include "document/player.hpp"
#include "files/file_access.hpp"
#include "project/repainting.hpp"
#include "recordings/canvas_support.hpp"
#include "recordings/replay_stats.hpp"

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

namespace pastoso::cli {
namespace {

void check_project_path(const std::string& path) {
    if (!project::is_project_path(path))
        throw core::InputError("%1: a painting is saved as .pastoso; this name ends otherwise.", path);
    files::check_writable(path);
}

void check_outputs(const ReplayOptions& options, const recordings::PictureStyle& style) {
    if (!options.output.empty()) files::check_picture_path(options.output, style.encoding);
    if (!options.well.empty()) files::check_picture_path(options.well, style.encoding);
    if (!options.save.empty()) check_project_path(options.save);
    if (!options.stats.empty()) files::check_writable(options.stats);
    if (!options.frames.empty()) files::make_folder(options.frames);
}

/// Plays to the end, writing frames where they are asked for.
void play(document::Painting& painting, const document::Recording& recording,
          const ReplayOptions& options, FrameWriter* frames) {
    painting.keep_undo_steps(document::undo_depth(recording));
    document::Player player(painting, recording, options.strokes);
    Progress progress("painting", Progress::style_for_stderr(options.quiet));
    while (!player.finished()) {
        stop_if_interrupted();
        if (frames != nullptr) frames->write_if_due(painting);
        player.play_tick();
        progress.update(player.progress());
    }
    if (frames != nullptr) frames->write_if_due(painting);
    stop_if_interrupted();
}

void save_painting(document::Painting& painting, const document::Recording& recording,
                   const std::string& path, core::ThreadPool& pool) {
    project::save_project(path, project::finished_project(painting, recording), pool);
}

recordings::ReplayStats stats_of(const document::Painting& painting, const PictureTimes& times,
                                 int threads) {
    recordings::ReplayStats stats;
    stats.brush_s = painting.stage_times().brush_s;
    stats.film_s = painting.stage_times().film_s;
    stats.shade_s = times.shade_s;
    stats.io_s = times.io_s;
    stats.film = painting.film_report();
    stats.wet_cells = film::wet_cell_count(painting.film());
    stats.account = painting.account();
    stats.state_hash = painting.state_hash();
    stats.threads = threads;
    stats.version = core::version();
    return stats;
}

void print_picture(const std::string& path, const PictureReport& picture) {
    if (path.empty()) return;
    print("%s: %d x %d pixels\n", path.c_str(), picture.width_px, picture.height_px);
}

void print_summary(const ReplayOptions& options, const document::Recording& recording,
                   const recordings::ReplayStats& stats, const PictureReport& picture,
                   const PictureReport& well, int frame_count) {
    const double painted_s = static_cast<double>(recording.end_tick) * document::kTick_s;
    print_picture(options.output, picture);
    print_picture(options.well, well);
    if (!options.save.empty()) print("%s: the painting\n", options.save.c_str());
    if (!options.frames.empty()) print("%s: %d frames\n", options.frames.c_str(), frame_count);
    if (!options.stats.empty()) print("%s: figures\n", options.stats.c_str());
    print("%.1f s of painting in %.1f s: brush %.1f, film %.1f, rendering %.1f, files %.1f\n", painted_s,
          stats.wall_s, stats.brush_s, stats.film_s, stats.shade_s, stats.io_s);
}

/// What a JSON recording says of its canvas, and no option instead, is the file's fault.
std::unique_ptr<document::Painting> painting_of(const ReplayOptions& options,
                                                const document::Recording& recording,
                                                core::ThreadPool& pool) {
    const auto make = [&] { return recordings::make_painting(recording.canvas, pool); };
    const bool by_options = options.canvas || options.px_per_mm || options.support || options.relief_mm;
    return by_options || !is_json_recording(options.strokes) ? make()
                                                             : core::naming(options.strokes, make);
}

}  // namespace

void run_replay(const ReplayOptions& options) {
    const Stopwatch wall;
    watch_for_interrupts();
    const recordings::PictureStyle style = recordings::picture_style(options.picture);
    check_outputs(options, style);
    document::Recording recording;
    const double reading_s = seconds_of([&] { recording = load_recording(options); });

    core::ThreadPool pool(options.threads);
    const std::unique_ptr<document::Painting> painting = painting_of(options, recording, pool);
    tell_arithmetic(options.strokes, recording);
    PictureWriter pictures(recording.canvas, options.scale, style, pool);
    FrameWriter frames(options.frames, options.fps, pictures);
    play(*painting, recording, options, options.frames.empty() ? nullptr : &frames);
    PictureReport picture, well;
    if (!options.output.empty()) picture = pictures.write(*painting, options.output);
    stop_if_interrupted();
    if (!options.well.empty()) well = pictures.write_well(*painting, options.well);
    stop_if_interrupted();

    double saving_s = 0.0;
    if (!options.save.empty())
        saving_s = seconds_of([&] { save_painting(*painting, recording, options.save, pool); });

    recordings::ReplayStats stats = stats_of(*painting, pictures.times(), pool.thread_count());
    stats.image_hash = picture.hash;
    stats.io_s += reading_s + saving_s;
    stats.wall_s = wall.seconds();
    if (!options.stats.empty()) recordings::write_stats(options.stats, stats);
    print_summary(options, recording, stats, picture, well, frames.frames_written());
}

void run_sheet(ReplayOptions options) {
    options.strokes = core::resource_path("strokes/sheet.json").string();
    run_replay(options);
}

}  // namespace pastoso::cli
