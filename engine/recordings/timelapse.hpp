// How a painting came about, as numbered pictures or as a video.
#pragma once

#include "core/thread_pool.hpp"
#include "document/events.hpp"
#include "recordings/export_bands.hpp"
#include "recordings/picture_style.hpp"
#include "shade/varnish.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::recordings {

struct TimelapseChoice {
    std::filesystem::path path;       ///< a folder for numbered pictures, or a video (video_file.hpp)
    double fps = 25.0;                ///< frames in a second of film
    double speed = 10.0;              ///< seconds of painting in a second of film
    std::optional<double> px_per_mm;  ///< to paint it on another canvas than it was painted on
    bool lit = true;
    double scale = 1.0;
    PictureOptions picture;  ///< a video has sRGB in 8 bits, whatever this says
    shade::Lighting lighting;
    shade::Varnish varnish;                 ///< over what is lit
    std::string strokes = "the recording";  ///< what is painted again, for errors
};

/// The ticks that frames show: even steps from the bare canvas on, and the end.
std::vector<std::int64_t> frame_ticks(const document::Recording& recording,
                                      const TimelapseChoice& choice);

/// How many those are.
std::int64_t frame_count(const document::Recording& recording, const TimelapseChoice& choice);

/// The pixels of every frame, `first` being the canvas that the painting began on. Throws InputError as
/// shade::picture_lattice() does.
grid::Shape timelapse_size(const document::CanvasSettings& first, const TimelapseChoice& choice);

/// Throws InputError where a video cannot be made, for a name that is neither a folder's nor a video's,
/// and for lights and profiles that there are not.
void check_timelapse(const TimelapseChoice& choice);

struct TimelapseReport {
    files::ExportStatus status = files::ExportStatus::Written;
    std::size_t frames = 0, written = 0;  ///< of a folder, those that were not there before
    int width_px = 0, height_px = 0;
};

/// Paints the recording again. A video takes its place when it is complete. A folder gets
/// frame-00001.png and so on, each of them written aside, and timelapse.txt, which says what they belong
/// to; frames that are there already are kept, so that the same choice goes on with what was stopped.
/// Throws InputError as check_timelapse() does, for a folder with frames of another time-lapse, for a
/// recording that cannot be painted, and when a file cannot be written.
TimelapseReport export_timelapse(document::Recording recording, const TimelapseChoice& choice,
                                 core::ThreadPool& pool, const files::KeepGoing& keep_going);

}  // namespace pastoso::recordings
