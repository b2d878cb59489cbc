#include "recordings/canvas_support.hpp"

#include "core/error.hpp"
#include "core/memory.hpp"
#include "document/canvas.hpp"
#include "document/cloth.hpp"
#include "files/image.hpp"
#include "film/support/support.hpp"
#include "grid/turning.hpp"
#include "layers/turning.hpp"

namespace pastoso::recordings {
namespace {

film::SupportHeights image_support(const document::CanvasSettings& settings, core::ThreadPool& pool) {
    if (settings.support_image.empty()) {
        throw core::InputError("The support \"image\" needs a height image; none is named.");
    }
    const files::GreyImage image = files::read_grey_image(settings.support_image);
    const double relief_mm =
        settings.support_relief_mm > 0.0 ? settings.support_relief_mm : kImageRelief_mm;
    const core::Orientation& turn = settings.support_turn;
    const grid::Shape stretched = grid::turned(document::canvas_shape(settings), core::reversed(turn));
    const film::SupportHeights heights_mm =
        film::image_support(stretched, image.values, image.width, image.height, relief_mm, pool);
    return layers::turned(heights_mm, turn, pool);
}

}  // namespace

film::SupportHeights make_support(const document::CanvasSettings& settings, core::ThreadPool& pool) {
    document::check_canvas_fits(settings, core::available_memory_bytes());
    if (settings.support == "image") return image_support(settings, pool);
    return document::heights_of_cloth(settings, pool);
}

std::unique_ptr<document::Painting> make_painting(const document::CanvasSettings& settings,
                                                  core::ThreadPool& pool) {
    return std::make_unique<document::Painting>(settings, make_support(settings, pool), pool);
}

}  // namespace pastoso::recordings
