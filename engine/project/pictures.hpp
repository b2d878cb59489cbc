// What other programs see of a painting: its layers as pictures in daylight.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting_state.hpp"
#include "files/keep_going.hpp"
#include "shade/render.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::project {

/// The longest side of those in a project.
inline constexpr int kLongestPicture_px = 2048;

/// All that lies at and below a layer, cut out where the layer holds paint: laid over one another, such
/// pictures show the painting as it is, and without the uppermost what lies below.
struct LayerPicture {
    std::string name;
    bool visible = true;
    pigment::Image8 picture;
    std::vector<std::uint8_t> covered{};  ///< 255 or 0 a pixel; empty: everywhere
};

struct Pictures {
    pigment::LinearImage merged;
    double px_per_mm = 1.0;
    /// From below. A painting of one layer is one picture; of several, the bare canvas comes first.
    std::vector<LayerPicture> layers{};
};

/// Of a canvas that is larger, a half, a fourth ... of the resolution is shown. None where `keep_going`
/// stopped it.
std::optional<Pictures> pictures_of(const document::PaintingState& painting, int longest_px,
                                    core::ThreadPool& pool, const files::KeepGoing& keep_going);

/// Those in a project.
Pictures pictures_of(const document::PaintingState& painting, core::ThreadPool& pool);

/// What load_thumbnail() gives of a project of that painting.
std::string thumbnail_file(const document::PaintingState& painting, core::ThreadPool& pool);

/// An entry of the archive: its name, and how its content is made of the pictures.
struct PictureFile {
    std::string entry;
    std::function<std::string()> content;
};

/// The pictures outlive them.
std::vector<PictureFile> picture_files(const Pictures& pictures);

/// OpenRaster's list of them (open_raster.hpp).
std::string stack_xml(const Pictures& pictures);

/// The entry of the painting's layer at that place.
std::string layer_picture(std::size_t place);

}  // namespace pastoso::project
