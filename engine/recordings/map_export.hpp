// Maps of a canvas for 3D programs: base colour, normal, height, roughness.
#pragma once

#include "core/thread_pool.hpp"
#include "files/picture_file.hpp"
#include "recordings/export_bands.hpp"

#include <filesystem>
#include <vector>

namespace pastoso::recordings {

/// The files of a set named by `path`, "DIR/NAME.png": DIR/NAME-basecolor.png, -normal, -height and
/// -roughness.
std::vector<std::filesystem::path> map_paths(const std::filesystem::path& path);

/// What the black and the white of the height map stand for.
struct MapHeights {
    double black_mm = 0.0, white_mm = 0.0;
};

/// Writes the set; its files take their places together, when all are complete.
///
/// base colour: the paint without light and shade, encoded as `encoding` says.
/// normal: of tangent space in the way of OpenGL, (1 + n) / 2 with red right, green up (+Y), blue out.
/// height: grey; see below.
/// roughness: grey, the square root of GGX's alpha.
///
/// .png and .tif with 8 or 16 bits keep heights in 16 bits, from 0 at `heights.black_mm` to 65535 at
/// `heights.white_mm`, which is written into the file's description. .tif with 32 bits and .exr keep
/// millimetres in single precision. Throws InputError for other formats and when a file cannot be
/// written.
files::ExportStatus export_maps(const std::filesystem::path& path, const ExportSource& source,
                                const files::PictureEncoding& encoding, core::ThreadPool& pool,
                                const files::KeepGoing& keep_going, MapHeights* heights = nullptr);

/// Asked before long work: throws InputError as export_maps() does.
void check_map_paths(const std::filesystem::path& path, const files::PictureEncoding& encoding);

}  // namespace pastoso::recordings
