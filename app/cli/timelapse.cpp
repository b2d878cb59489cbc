#include "cli/timelapse.hpp"

#include "cli/interrupt.hpp"
#include "cli/printing.hpp"
#include "cli/progress.hpp"
#include "cli/recording_source.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "core/thread_pool.hpp"
#include "files/video_file.hpp"
#include "project/project.hpp"
#include "recordings/timelapse.hpp"

#include <cstdio>

namespace pastoso::cli {
namespace {

document::Recording strokes_of_project(const std::string& path, core::ThreadPool& pool) {
    project::LoadedProject project = project::load_project(path, pool);
    for (const core::Message& note : project.notes)
        complain(note.text());
    if (project.strokes.events.empty())
        throw core::InputError("%1: holds no strokes that could be shown again.", path);
    return std::move(project.strokes);
}

document::Recording recording_of(const TimelapseOptions& options, core::ThreadPool& pool) {
    if (project::is_project_path(options.source)) return strokes_of_project(options.source, pool);
    ReplayOptions replay;
    replay.strokes = options.source;
    replay.px_per_mm = options.px_per_mm;
    return load_recording(replay);
}

recordings::TimelapseChoice choice_of(const TimelapseOptions& options) {
    recordings::TimelapseChoice choice;
    choice.path = options.output;
    choice.fps = options.fps;
    choice.speed = options.speed;
    choice.px_per_mm = options.px_per_mm;
    choice.lit = !options.flat;
    choice.scale = options.scale;
    choice.picture = options.picture;
    choice.strokes = options.source;
    return choice;
}

void check_usage(const TimelapseOptions& options) {
    if (!files::is_video_path(options.output)) return;
    if (options.picture.profile != "srgb" || options.picture.depth_bits != 8)
        throw UsageError("--profile and --depth are for numbered pictures; a video has 8 bits sRGB.");
}

void tell(const recordings::TimelapseChoice& choice, const recordings::TimelapseReport& report) {
    if (files::is_video_path(choice.path))
        print("%s: %zu frames of %d x %d pixels\n", choice.path.c_str(), report.frames, report.width_px,
              report.height_px);
    else
        print("%s: %zu frames, %zu of them new\n", choice.path.c_str(), report.frames, report.written);
}

}  // namespace

void run_timelapse(const TimelapseOptions& options) {
    watch_for_interrupts();
    check_usage(options);
    const recordings::TimelapseChoice choice = choice_of(options);
    recordings::check_timelapse(choice);
    core::ThreadPool pool(options.threads);
    const document::Recording recording = recording_of(options, pool);
    Progress progress("painting", Progress::style_for_stderr(options.quiet));
    const recordings::TimelapseReport report =
        recordings::export_timelapse(recording, choice, pool, [&](double done) {
            progress.update(done);
            return !is_interrupted();
        });
    if (report.status == files::ExportStatus::Stopped) throw Interrupted{};
    progress.clear();
    if (!project::is_project_path(options.source)) tell_arithmetic(options.source, recording);
    tell(choice, report);
}

}  // namespace pastoso::cli
