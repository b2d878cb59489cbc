// Pictures of a canvas in files, of any size that a file can have: rendered and written band by band.
#pragma once

#include "core/thread_pool.hpp"
#include "files/picture_file.hpp"
#include "recordings/export_bands.hpp"

#include <filesystem>
#include <functional>

namespace pastoso::recordings {

/// Is shown the rows of a band before they are written.
using BandViewer = std::function<void(const pigment::LinearImage& rows)>;

/// The picture, lit or not, as write_picture() would write it. Throws InputError for what the format
/// does not hold and when the file cannot be written.
files::ExportStatus export_picture(
    const std::filesystem::path& path, const ExportSource& source,
    const files::PictureEncoding& encoding, core::ThreadPool& pool, const files::KeepGoing& keep_going,
    const BandViewer& view = [](const pigment::LinearImage&) {});

/// The picture for a film whose frames are as large as the picture of a canvas of `first` cells at the
/// scale of `source`: a canvas that was cut or made larger on the way is shown as large as fits, in the
/// middle, on grey.
pigment::LinearImage frame_picture(ExportSource source, const grid::Shape& first,
                                   core::ThreadPool& pool);

/// The pixels of a rectangle of the picture of a source.
void render_picture(const shade::Renderer& renderer, const ExportSource& source,
                    const grid::Rect& pixels, pigment::LinearImage* picture);

}  // namespace pastoso::recordings
