// Pictures of a canvas in files, of any size that a file can have: rendered and written band by band.
#pragma once

#include "core/thread_pool.hpp"
#include "io/export_bands.hpp"
#include "io/picture_file.hpp"

#include <filesystem>
#include <string>

namespace pastoso::io {

/// The lit picture, as write_picture() would write it. Throws InputError for what the format does not
/// hold and when the file cannot be written.
ExportStatus export_picture(const std::filesystem::path& path, const ExportSource& source,
                            const PictureEncoding& encoding, core::ThreadPool& pool,
                            const KeepGoing& keep_going);

/// An OpenEXR file for compositing: the lit picture as R, G and B, and for the layer, a group of
/// channels for each property:
///
///     <layer>.lit.R G B        the picture under the light, halves
///     <layer>.albedo.R G B     its colours without any light, halves
///     <layer>.normal.X Y Z     unit normal of the surface: X right, Y up, Z out of the canvas, halves
///     <layer>.height_mm.V      support and paint above level 0 of the support, single precision
///     <layer>.wetness.V        0 dry to 1 wet, halves
///     <layer>.gloss.V          1 - roughness (surface_values.hpp), halves
///
/// Throws InputError unless `path` ends in .exr, and when it cannot be written.
ExportStatus export_layers(const std::filesystem::path& path, const ExportSource& source,
                           const std::string& layer, core::ThreadPool& pool,
                           const KeepGoing& keep_going);

}  // namespace pastoso::io
