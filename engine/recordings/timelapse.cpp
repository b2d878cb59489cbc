#include "recordings/timelapse.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/looking.hpp"
#include "core/memory.hpp"
#include "core/naming.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "core/version.hpp"
#include "document/canvas.hpp"
#include "document/player.hpp"
#include "files/file_access.hpp"
#include "files/video_file.hpp"
#include "recordings/canvas_support.hpp"
#include "recordings/picture_export.hpp"
#include "recordings/recording_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>

namespace pastoso::recordings {
namespace {

using core::number_text;
using document::Recording;
using Path = std::filesystem::path;

constexpr const char* kRecordName = "timelapse.txt";

double step_of(const TimelapseChoice& choice) {
    return choice.speed / (choice.fps * document::kTick_s);
}

std::int64_t even_tick(const TimelapseChoice& choice, std::int64_t frame) {
    return std::llround(step_of(choice) * static_cast<double>(frame));
}

/// Paints as far as the last frame that is wanted and calls show(frame, snapshot) for those that are.
/// False when `keep_going` said so.
bool play(const Recording& recording, const TimelapseChoice& choice, const std::vector<bool>& wanted,
          core::ThreadPool& pool, const files::KeepGoing& keep_going,
          const std::function<void(std::size_t frame, const document::Snapshot&)>& show) {
    const std::vector<std::int64_t> ticks = frame_ticks(recording, choice);
    const auto make = [&] { return make_painting(recording.canvas, pool); };
    const std::unique_ptr<document::Painting> painting = core::naming(choice.strokes, make);
    painting->keep_undo_steps(document::undo_depth(recording));
    document::Player player(*painting, recording, choice.strokes);
    for (std::size_t frame = 0; frame < wanted.size(); ++frame) {
        const bool at_end = ticks[frame] == recording.end_tick;
        while (at_end ? !player.finished() : painting->tick() < ticks[frame]) {
            if (!keep_going(player.progress())) return false;
            player.play_tick();
        }
        if (wanted[frame]) show(frame, painting->snapshot());
    }
    return keep_going(1.0);
}

ExportSource source_of(const document::Snapshot& snapshot, const TimelapseChoice& choice,
                       const PictureStyle& style) {
    shade::RenderSettings settings;
    settings.scale = choice.scale;
    const shade::Varnish varnish = choice.lit ? choice.varnish : shade::Varnish{};
    settings.lighting = shade::varnished(choice.lighting, varnish);
    settings.viewing = shade::varnished(style.viewing, varnish);
    return {snapshot.film, snapshot.ground, settings, choice.lit};
}

/// Nothing without one: folders from before there was varnish go on as they are.
std::string varnish_record(const TimelapseChoice& choice) {
    const shade::Varnish& varnish = choice.varnish;
    if (!choice.lit || varnish.finish == shade::Finish::None) return "";
    return "\nvarnish: " + std::to_string(static_cast<int>(varnish.finish)) + ", " +
           number_text(varnish.amount) + ", aged " + number_text(varnish.yellowing);
}

/// What decides on the frames of a folder, so that frames of another time-lapse are not mixed in.
std::string record_of(const Recording& recording, const TimelapseChoice& choice) {
    core::Hash64 strokes;
    const std::string text = recording_to_json(recording);
    strokes.add(std::span<const char>(text));
    const PictureOptions& picture = choice.picture;
    const shade::Lighting& lighting = choice.lighting;
    return std::string("Pastoso ") + core::version() + " time-lapse\nstrokes: " + strokes.hex() +
           "\nfps: " + number_text(choice.fps) + "\nspeed: " + number_text(choice.speed) +
           "\nscale: " + number_text(choice.scale) + "\nlight: " + picture.light + ", " +
           (choice.lit ? number_text(lighting.azimuth_deg) + " deg round, " +
                             number_text(lighting.elevation_deg) + " deg high"
                       : "without shade") +
           varnish_record(choice) + "\nprofile: " + picture.profile +
           "\ndepth: " + std::to_string(picture.depth_bits) + "\n";
}

Path frame_path(const Path& folder, std::size_t frame) {
    char name[40];
    std::snprintf(name, sizeof name, "frame-%05zu.png", frame + 1);
    return folder / name;
}

/// Makes the folder one of this time-lapse, or finds that it is. Throws InputError for another's.
void claim_folder(const Path& folder, const std::string& record) {
    files::make_folder(folder);
    const Path path = folder / kRecordName;
    if (core::is_there(path)) {
        if (core::read_text_file(path) == record) return;
    } else if (!core::is_there(frame_path(folder, 0))) {
        core::write_text_file(path, record);
        return;
    }
    throw core::InputError(
        "%1: holds frames of another time-lapse; name another folder, or remove them.", folder.string());
}

/// As far as the last of them.
std::vector<bool> missing_frames(const Path& folder, std::size_t frames) {
    std::vector<bool> missing;
    std::size_t end = 0;
    for (std::size_t frame = 0; frame < frames; ++frame) {
        missing.push_back(!core::is_there(frame_path(folder, frame)));
        if (missing.back()) end = frame + 1;
    }
    missing.resize(end);
    return missing;
}

bool write_frames(const Recording& recording, const TimelapseChoice& choice, core::ThreadPool& pool,
                  const files::KeepGoing& keep_going, TimelapseReport& report) {
    const PictureStyle style = picture_style(choice.picture);
    files::check_picture_path(frame_path(choice.path.parent_path(), 0), style.encoding);
    claim_folder(choice.path, record_of(recording, choice));
    const grid::Shape first = document::canvas_shape(recording.canvas);
    const auto to_the_end = [](double) { return true; };
    return play(recording, choice, missing_frames(choice.path, report.frames), pool, keep_going,
                [&](std::size_t frame, const document::Snapshot& snapshot) {
                    const ExportSource source = source_of(snapshot, choice, style);
                    const Path path = frame_path(choice.path, frame);
                    if (snapshot.film.shape == first)
                        export_picture(path, source, style.encoding, pool, to_the_end);
                    else
                        files::write_picture(path, frame_picture(source, first, pool), style.encoding,
                                             choice.scale / snapshot.film.cell_mm);
                    ++report.written;
                });
}

bool write_video(const Recording& recording, const TimelapseChoice& choice, core::ThreadPool& pool,
                 const files::KeepGoing& keep_going, TimelapseReport& report) {
    PictureStyle style = picture_style(choice.picture);
    style.viewing.space = pigment::WorkingSpace::Srgb;
    const grid::Shape first = document::canvas_shape(recording.canvas);
    return core::write_aside_unless(choice.path, [&](core::OutputFile& file) {
        files::VideoWriter video(file, report.width_px, report.height_px, choice.fps);
        const bool complete = play(recording, choice, std::vector<bool>(report.frames, true), pool,
                                   keep_going, [&](std::size_t, const document::Snapshot& snapshot) {
                                       video.write(pigment::encode_srgb8(frame_picture(
                                           source_of(snapshot, choice, style), first, pool)));
                                       ++report.written;
                                   });
        if (complete) video.finish();
        return complete;
    });
}

}  // namespace

std::vector<std::int64_t> frame_ticks(const Recording& recording, const TimelapseChoice& choice) {
    std::vector<std::int64_t> ticks;
    for (std::int64_t tick = 0; tick < recording.end_tick;
         tick = even_tick(choice, static_cast<std::int64_t>(ticks.size())))
        ticks.push_back(tick);
    ticks.push_back(recording.end_tick);
    return ticks;
}

std::int64_t frame_count(const Recording& recording, const TimelapseChoice& choice) {
    auto frame = static_cast<std::int64_t>(static_cast<double>(recording.end_tick) / step_of(choice));
    while (frame > 0 && even_tick(choice, frame - 1) >= recording.end_tick)
        --frame;
    while (even_tick(choice, frame) < recording.end_tick)
        ++frame;
    return frame + 1;
}

grid::Shape timelapse_size(const document::CanvasSettings& first, const TimelapseChoice& choice) {
    document::CanvasSettings canvas = first;
    if (choice.px_per_mm) canvas.px_per_mm = *choice.px_per_mm;
    const grid::Shape shape = document::canvas_shape(canvas);
    const shade::Lattice lattice = shade::picture_lattice(shape, shape.cells(), choice.scale);
    return {lattice.width, lattice.height};
}

void check_timelapse(const TimelapseChoice& choice) {
    picture_style(choice.picture);
    if (files::is_video_path(choice.path)) {
        files::check_video_path(choice.path);
    } else if (choice.path.has_extension() && !core::is_folder(choice.path)) {
        throw core::InputError(
            "%1: a video is saved as .mp4, .mkv or .webm, and a folder's name has no ending.",
            choice.path.string());
    }
}

TimelapseReport export_timelapse(Recording recording, const TimelapseChoice& choice,
                                 core::ThreadPool& pool, const files::KeepGoing& keep_going) {
    check_timelapse(choice);
    if (choice.px_per_mm) recording.canvas.px_per_mm = *choice.px_per_mm;
    document::check_canvas_fits(recording.canvas, core::available_memory_bytes());
    const grid::Shape size = timelapse_size(recording.canvas, choice);
    TimelapseReport report{.frames = frame_ticks(recording, choice).size(),
                           .width_px = size.width,
                           .height_px = size.height};
    const auto write = files::is_video_path(choice.path) ? write_video : write_frames;
    const bool complete = write(recording, choice, pool, keep_going, report);
    report.status = complete ? files::ExportStatus::Written : files::ExportStatus::Stopped;
    return report;
}

}  // namespace pastoso::recordings
