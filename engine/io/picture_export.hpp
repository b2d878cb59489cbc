// Pictures of a canvas in files, of any size that a file can have: rendered and written band by band.
#pragma once

#include "core/thread_pool.hpp"
#include "io/export_bands.hpp"
#include "io/picture_file.hpp"

#include <filesystem>

namespace pastoso::io {

/// The picture, lit or not, as write_picture() would write it. Throws InputError for what the format
/// does not hold and when the file cannot be written.
ExportStatus export_picture(const std::filesystem::path& path, const ExportSource& source,
                            const PictureEncoding& encoding, core::ThreadPool& pool,
                            const KeepGoing& keep_going);

/// The pixels of a rectangle of that picture.
void render_picture(const shade::Renderer& renderer, const ExportSource& source,
                    const grid::Rect& pixels, shade::LinearImage* picture);

}  // namespace pastoso::io
