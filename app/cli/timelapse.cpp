#include "cli/timelapse.hpp"

#include "cli/interrupt.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/recording_source.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/text_file.hpp"
#include "core/thread_pool.hpp"
#include "document/number_text.hpp"
#include "document/player.hpp"
#include "io/canvas_support.hpp"
#include "io/files.hpp"
#include "io/recording_json.hpp"
#include "io/video_file.hpp"
#include "project/project.hpp"
#include "shade/render.hpp"

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace pastoso::cli {
namespace {

using document::number_text;
using document::Recording;
using Path = std::filesystem::path;

constexpr const char* kRecordName = "timelapse.txt";

Recording strokes_of_project(const TimelapseOptions& options, core::ThreadPool& pool) {
    project::LoadedProject project = project::load_project(options.source, pool);
    for (const std::string& note : project.notes)
        std::fprintf(stderr, "pastoso-cli: %s\n", note.c_str());
    if (project.strokes.events.empty())
        throw core::InputError(options.source + ": holds no strokes that could be shown again.");
    if (options.px_per_mm) project.strokes.canvas.px_per_mm = *options.px_per_mm;
    return std::move(project.strokes);
}

Recording recording_of(const TimelapseOptions& options, core::ThreadPool& pool) {
    if (project::is_project_path(options.source)) return strokes_of_project(options, pool);
    ReplayOptions replay;
    replay.strokes = options.source;
    replay.px_per_mm = options.px_per_mm;
    return load_recording(replay);
}

/// The ticks that frames show: even steps from the bare canvas on, and the end.
std::vector<std::int64_t> frame_ticks(const Recording& recording, const TimelapseOptions& options) {
    const double step = options.speed / (options.fps * document::kTick_s);
    std::vector<std::int64_t> ticks;
    for (std::int64_t tick = 0; tick < recording.end_tick;
         tick = std::llround(step * static_cast<double>(ticks.size())))
        ticks.push_back(tick);
    ticks.push_back(recording.end_tick);
    return ticks;
}

/// Plays the recording and calls show(frame) at the tick of every frame from the first that is wanted to
/// the last.
void play(document::Painting& painting, const Recording& recording,
          const std::vector<std::int64_t>& ticks, const std::vector<bool>& wanted,
          const TimelapseOptions& options, const std::function<void(std::size_t frame)>& show) {
    if (!document::undoes(recording)) painting.set_history_budget(0);
    document::Player player(painting, recording);
    Progress progress("painting", Progress::style_for_stderr(options.quiet));
    for (std::size_t frame = 0; frame < ticks.size(); ++frame) {
        const bool at_end = ticks[frame] == recording.end_tick;
        while (at_end ? !player.finished() : painting.tick() < ticks[frame]) {
            stop_if_interrupted();
            try {
                player.play_tick();
            } catch (const core::InputError& error) {
                throw core::InputError(options.source + ", " + error.what());
            }
            progress.update(player.progress());
        }
        if (wanted[frame]) show(frame);
    }
}

/// What decides on the frames of a folder, so that frames of another time-lapse are not mixed in.
std::string record_of(const Recording& recording, const TimelapseOptions& options) {
    core::Hash64 strokes;
    const std::string text = io::recording_to_json(recording);
    strokes.add(std::span<const char>(text));
    const PictureOptions& picture = options.picture;
    return "Pastoso " PASTOSO_VERSION " time-lapse\nstrokes: " + strokes.hex() +
           "\nfps: " + number_text(options.fps) + "\nspeed: " + number_text(options.speed) +
           "\nscale: " + number_text(options.scale) + "\nlight: " + picture.light +
           "\nprofile: " + picture.profile + "\ndepth: " + std::to_string(picture.depth_bits) + "\n";
}

Path frame_path(const Path& folder, std::size_t frame) {
    char name[40];
    std::snprintf(name, sizeof name, "frame-%05zu.png", frame + 1);
    return folder / name;
}

/// Makes the folder one of this time-lapse, or finds that it is. Throws InputError for another's.
void claim_folder(const Path& folder, const std::string& record) {
    io::make_folder(folder);
    const Path path = folder / kRecordName;
    if (std::filesystem::exists(path)) {
        if (core::read_text_file(path) == record) return;
    } else if (!std::filesystem::exists(frame_path(folder, 0))) {
        core::write_text_file(path, record);
        return;
    }
    throw core::InputError(folder.string() +
                           ": holds frames of another time-lapse; name another folder, or remove them.");
}

void write_frames(const Recording& recording, const TimelapseOptions& options, const PictureStyle& style,
                  core::ThreadPool& pool) {
    const std::vector<std::int64_t> ticks = frame_ticks(recording, options);
    PictureWriter pictures(recording.canvas, options.scale, style, pool);
    const std::unique_ptr<document::Painting> painting = io::make_painting(recording.canvas, pool);
    claim_folder(options.output, record_of(recording, options));
    std::vector<bool> missing;
    std::size_t end = 0;
    for (std::size_t frame = 0; frame < ticks.size(); ++frame) {
        missing.push_back(!std::filesystem::exists(frame_path(options.output, frame)));
        if (missing.back()) end = frame + 1;
    }
    const std::vector<std::int64_t> until(ticks.begin(),
                                          ticks.begin() + static_cast<std::ptrdiff_t>(end));
    std::size_t written = 0;
    play(*painting, recording, until, missing, options, [&](std::size_t frame) {
        pictures.write_frame(*painting, frame_path(options.output, frame));
        ++written;
    });
    std::printf("%s: %zu frames, %zu of them new\n", options.output.c_str(), ticks.size(), written);
}

void write_video(const Recording& recording, const TimelapseOptions& options, const PictureStyle& style,
                 core::ThreadPool& pool) {
    const std::vector<std::int64_t> ticks = frame_ticks(recording, options);
    const std::unique_ptr<document::Painting> painting = io::make_painting(recording.canvas, pool);
    PictureWriter pictures(recording.canvas, options.scale, style, pool);
    const grid::Shape canvas = painting->film().shape;
    const shade::Lattice size = shade::picture_lattice(canvas, canvas.cells(), options.scale);
    core::write_aside(options.output, [&](const Path& temporary) {
        io::VideoWriter video(temporary, options.output, size.width, size.height, options.fps);
        const std::vector<bool> all(ticks.size(), true);
        play(*painting, recording, ticks, all, options,
             [&](std::size_t) { video.write(shade::encode_srgb8(pictures.frame(*painting))); });
        video.finish();
    });
    std::printf("%s: %zu frames of %d x %d pixels\n", options.output.c_str(), ticks.size(), size.width,
                size.height);
}

void check_request(const TimelapseOptions& options) {
    if (io::is_video_path(options.output)) {
        if (options.picture.profile != "srgb" || options.picture.depth_bits != 8)
            throw UsageError(
                "--profile and --depth are for numbered pictures; a video has 8 bits sRGB.");
        io::check_video_path(options.output);
    } else if (Path(options.output).has_extension() && !std::filesystem::is_directory(options.output)) {
        throw core::InputError(options.output +
                               ": a video is saved as .mp4, .mkv or .webm, and a folder's name has no "
                               "ending.");
    }
}

}  // namespace

void run_timelapse(const TimelapseOptions& options) {
    watch_for_interrupts();
    const PictureStyle style = picture_style(options.picture);
    check_request(options);
    core::ThreadPool pool(options.threads);
    const Recording recording = recording_of(options, pool);
    if (io::is_video_path(options.output))
        write_video(recording, options, style, pool);
    else
        write_frames(recording, options, style, pool);
}

}  // namespace pastoso::cli
