// A painting for compositing programs: every layer of it with all that can be told of its surface.
#pragma once

#include "core/thread_pool.hpp"
#include "document/layered_canvas.hpp"
#include "recordings/export_bands.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace pastoso::recordings {

/// A layer apart from what it lies on (layers/apart.hpp), under a name for channels.
struct ChannelLayer {
    std::string name;
    std::shared_ptr<const film::FilmState> film;
};

/// The layers of a painting from below, the hidden ones too.
struct ChannelLayers {
    film::SupportHeights bare_mm;  ///< the support that they lie on
    std::vector<ChannelLayer> layers;
    std::string description;  ///< which name stands for which layer, and how it was seen
};

/// `film` is the active layer of the stack on what is visible below it, and `bare_mm` the bare support.
ChannelLayers channel_layers(const film::FilmState& film, const film::SupportHeights& bare_mm,
                             const document::LayerStack& stack);

/// An OpenEXR file: the picture of `source`, lit or not, as R, G and B; the heights of the bare support;
/// and for each layer, as if it alone lay on the support and none of it were faded; of a layer that is
/// clipped, what shows,
///
///     <layer>.lit.R G B        the picture under the light, halves
///     <layer>.albedo.R G B     its colours without any light, halves
///     <layer>.normal.X Y Z     unit normal of the surface: X right, Y up, Z out of the canvas, halves
///     <layer>.height_mm.V      support and paint above level 0 of the support, single precision
///     <layer>.wetness.V        0 dry to 1 wet, halves
///     <layer>.gloss.V          1 - roughness (surface_values.hpp), halves
///     <layer>.cover.A          share of the cells below the pixel that hold paint of it, halves
///     support.height_mm.V      single precision
///
/// Throws InputError unless `path` ends in .exr, and when it cannot be written.
files::ExportStatus export_layers(const std::filesystem::path& path, const ExportSource& source,
                                  const ChannelLayers& layers, core::ThreadPool& pool,
                                  const files::KeepGoing& keep_going);

}  // namespace pastoso::recordings
