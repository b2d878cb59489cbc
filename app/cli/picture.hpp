// Rendering the painting into files, with the time it takes.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "recordings/picture_style.hpp"
#include "shade/render.hpp"

#include <cstdint>
#include <filesystem>

namespace pastoso::cli {

/// Seconds of wall time so far.
struct PictureTimes {
    double shade_s = 0.0;
    double io_s = 0.0;
};

/// What became of a picture.
struct PictureReport {
    int width_px = 0, height_px = 0;
    std::uint64_t hash = 0;  ///< of the size and, band by band, the 8-bit values in the working space
};

class PictureWriter {
  public:
    /// `scale` in pixels per cell. Throws InputError when the picture would be too large.
    PictureWriter(const document::CanvasSettings& canvas, double scale, recordings::PictureStyle style,
                  core::ThreadPool& pool);

    /// Renders the whole canvas and writes it to `path`.
    PictureReport write(const document::Painting& painting, const std::filesystem::path& path);

    /// The same of the mixing well.
    PictureReport write_well(const document::Painting& painting, const std::filesystem::path& path);

    /// The picture for a sequence, as large as that of the canvas named at first
    /// (recordings::frame_picture).
    void write_frame(const document::Painting& painting, const std::filesystem::path& path);

    const PictureTimes& times() const { return times_; }

  private:
    shade::RenderSettings settings() const;
    PictureReport save(const film::FilmState& film, const pigment::Bands& ground,
                       const std::filesystem::path& path);

    grid::Shape canvas_;
    double scale_;
    recordings::PictureStyle style_;
    core::ThreadPool& pool_;
    PictureTimes times_;
};

/// Writes frame-00001.png and so on into a folder, one for every 1/fps seconds of paint time.
class FrameWriter {
  public:
    FrameWriter(std::filesystem::path folder, double fps, PictureWriter& pictures)
        : folder_(std::move(folder)), fps_(fps), pictures_(pictures) {}

    /// To be called at every tick; writes a frame when its time has come.
    void write_if_due(const document::Painting& painting);

    int frames_written() const { return frames_written_; }

  private:
    std::filesystem::path folder_;
    double fps_;
    PictureWriter& pictures_;
    int frames_written_ = 0;
};

}  // namespace pastoso::cli
