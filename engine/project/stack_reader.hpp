// The list of layers in OpenRaster files of other programs (stack.xml), as far as Pastoso has what it
// says.
#pragma once

#include "core/message.hpp"
#include "document/actions/layer_actions.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::project {

inline constexpr std::size_t kMostStackBytes = std::size_t{4} << 20;

/// A layer's picture and where its upper left corner lies, in pixels.
struct StackPicture {
    std::string source;  ///< name of the archive's entry
    document::LayerLook look{};
    int x = 0, y = 0;
    std::size_t group = 0;  ///< number of its group, counted from 1; 0: in none
};

struct RasterStack {
    int width = 0, height = 0;                    ///< in pixels
    double px_per_mm_x = 0.0, px_per_mm_y = 0.0;  ///< 0: not said
    std::vector<StackPicture> pictures;           ///< the lowest first
    std::vector<document::LayerLook> groups;
    std::vector<core::Message> notes;  ///< what of the file Pastoso leaves out, in sentences
};

/// Reads OpenRaster's stack.xml (version 0.0.6 of its specification). Groups within groups become part
/// of the outermost, their visibility and opacity that of their layers. Layers that show only
/// where something lies below (svg:src-atop) are clipped to the layer below. Names are shortened to what
/// a layer's may have. Throws InputError "NAME, line N: ..." for what is no XML, has a document type, is
/// nested deeper than 32 elements or has sizes or numbers out of range.
RasterStack read_stack(std::string_view xml, const std::string& name);

}  // namespace pastoso::project
