#include "cli/picture.hpp"

#include "cli/stopwatch.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/number_text.hpp"
#include "document/canvas.hpp"
#include "document/well.hpp"
#include "recordings/picture_export.hpp"
#include "shade/render.hpp"

#include <algorithm>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

namespace pastoso::cli {
namespace {

void check_picture_size(const grid::Shape& shape, double scale) {
    const double longest = scale * std::max(shape.width, shape.height);
    const double pixels = scale * scale * shape.width * shape.height;
    if (longest <= 32768.0 && pixels <= 4e8) return;
    throw core::InputError(
        "A picture at --scale %1 would be %2 x %3 pixels; at most 32768 a side and 400 million in all "
        "are "
        "possible.",
        scale, static_cast<long>(scale * shape.width), static_cast<long>(scale * shape.height));
}

}  // namespace

PictureWriter::PictureWriter(const document::CanvasSettings& canvas, double scale,
                             recordings::PictureStyle style, core::ThreadPool& pool)
    : canvas_(document::canvas_shape(canvas)), scale_(scale), style_(std::move(style)), pool_(pool) {
    check_picture_size(canvas_, scale);
}

PictureReport PictureWriter::write(const document::Painting& painting,
                                   const std::filesystem::path& path) {
    const document::Snapshot snapshot = painting.snapshot();
    check_picture_size(snapshot.film.shape, scale_);
    return save(snapshot.film, snapshot.ground, path);
}

PictureReport PictureWriter::write_well(const document::Painting& painting,
                                        const std::filesystem::path& path) {
    const document::Snapshot snapshot = painting.snapshot();
    const film::FilmState well = snapshot.well.value_or(document::bare_well());
    return save(well, snapshot.ground, path);
}

void PictureWriter::write_frame(const document::Painting& painting, const std::filesystem::path& path) {
    const document::Snapshot snapshot = painting.snapshot();
    pigment::LinearImage frame;
    times_.shade_s += seconds_of([&] {
        frame = recordings::frame_picture({snapshot.film, snapshot.ground, settings()}, canvas_, pool_);
    });
    times_.io_s += seconds_of(
        [&] { files::write_picture(path, frame, style_.encoding, scale_ / snapshot.film.cell_mm); });
}

shade::RenderSettings PictureWriter::settings() const {
    shade::RenderSettings wanted;
    wanted.scale = scale_;
    wanted.viewing = style_.viewing;
    return wanted;
}

PictureReport PictureWriter::save(const film::FilmState& film, const pigment::Bands& ground,
                                  const std::filesystem::path& path) {
    const recordings::ExportSource source{film, ground, settings()};
    const shade::Lattice size = recordings::export_lattice(source);
    core::Hash64 hash;
    hash.add_value(size.width);
    hash.add_value(size.height);
    Stopwatch since_band_began;
    double rendering_s = 0.0;
    const auto begin_band = [&](double) {
        since_band_began = {};
        return true;
    };
    const auto note_rendered = [&](const pigment::LinearImage& rows) {
        rendering_s += since_band_began.seconds();
        hash.add(std::span<const std::uint8_t>(pigment::encode_srgb8(rows).rgb));
    };
    const double in_all_s = seconds_of([&] {
        recordings::export_picture(path, source, style_.encoding, pool_, begin_band, note_rendered);
    });
    times_.shade_s += rendering_s;
    times_.io_s += in_all_s - rendering_s;
    return {size.width, size.height, hash.value()};
}

void FrameWriter::write_if_due(const document::Painting& painting) {
    const double passed_s = static_cast<double>(painting.tick()) * document::kTick_s;
    // Half a tick of slack: a frame is due at the tick nearest to its time.
    if (passed_s + 0.5 * document::kTick_s < frames_written_ / fps_) return;
    char name[32];
    std::snprintf(name, sizeof name, "frame-%05d.png", ++frames_written_);
    pictures_.write_frame(painting, folder_ / name);
}

}  // namespace pastoso::cli
