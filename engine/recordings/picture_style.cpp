#include "recordings/picture_style.hpp"

#include "pigment/illuminant.hpp"

#include <utility>

namespace pastoso::recordings {

PictureStyle picture_style(const PictureOptions& options) {
    files::PictureColours colours = files::picture_colours(options.profile);
    return {pigment::viewing_under(pigment::find_illuminant(options.light), colours.space),
            {options.depth_bits, std::move(colours.profile), options.quality}};
}

}  // namespace pastoso::recordings
