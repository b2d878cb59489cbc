#include "project/pictures.hpp"

#include "document/layered_canvas.hpp"
#include "document/painting.hpp"
#include "files/image.hpp"
#include "layers/apart.hpp"
#include "pigment/colour.hpp"
#include "project/coarse_film.hpp"
#include "project/open_raster.hpp"
#include "project/project.hpp"

#include <algorithm>
#include <memory>

namespace pastoso::project {
namespace {

using document::LayerStack;
using document::PaintingState;

int coarseness(const grid::Shape& shape, int longest_px) {
    int factor = 1;
    while (std::max(shape.width, shape.height) > factor * longest_px)
        factor *= 2;
    return factor;
}

film::FilmState small_film(const film::FilmState& film, int factor, core::ThreadPool& pool) {
    return factor == 1 ? film : coarse_film(film, factor, pool);
}

pigment::LinearImage picture_of(const film::FilmState& film, int factor, core::ThreadPool& pool) {
    const film::FilmState small = small_film(film, factor, pool);
    return shade::render(small, document::kPrimedGround, small.shape.cells(), {}, pool);
}

pigment::LinearImage linear_of(const pigment::Picture& picture) {
    pigment::LinearImage linear{picture.width, picture.height, {}, {}};
    linear.rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3)
            linear.rgb.push_back(static_cast<float>(pigment::decode_srgb(picture.rgba[i] / 255.0)));
    return linear;
}

/// Where a layer holds paint.
std::vector<std::uint8_t> cover_of(const film::FilmState& layer, int factor, core::ThreadPool& pool) {
    const film::FilmState small = small_film(layer, factor, pool);
    std::vector<std::uint8_t> covered;
    covered.reserve(static_cast<std::size_t>(small.shape.width) * small.shape.height);
    for (int y = 0; y < small.shape.height; ++y) {
        for (int x = 0; x < small.shape.width; ++x) {
            covered.push_back(layers::holds_paint(small, x, y) ? 255 : 0);
        }
    }
    return covered;
}

/// Each view is one layer laid over that of all below: a View keeps what it saw. Returns whether it went
/// on to the end.
bool add_layer_pictures(const PaintingState& painting, int factor, core::ThreadPool& pool,
                        const files::KeepGoing& keep_going, Pictures& pictures) {
    const film::FilmState& film = painting.value.film;
    film::FilmState canvas(film.shape, film.cell_mm);
    canvas.support_mm = painting.value.bare->support_mm;
    pictures.merged = picture_of(canvas, factor, pool);
    pictures.layers = {{"Canvas", true, pigment::encode_srgb8(pictures.merged), {}}};
    const document::LayerFilms films = document::shown_layers(
        document::layers_apart(film, painting.value.bare->support_mm, painting.value.layers),
        painting.value.layers);
    layers::View view;
    std::vector<layers::SeenLayer> seen;
    for (std::size_t place = 0; place < films.size(); ++place) {
        if (!keep_going(static_cast<double>(place) / static_cast<double>(films.size()))) return false;
        const document::LayerLook look = document::effective_look(painting.value.layers, place);
        seen.push_back({films[place].get(), look.opacity});
        pigment::LinearImage picture = picture_of(view.of(canvas, seen, pool), factor, pool);
        pictures.layers.push_back({look.name, look.visible, pigment::encode_srgb8(picture),
                                   cover_of(*films[place], factor, pool)});
        if (look.visible)
            pictures.merged = std::move(picture);
        else
            seen.pop_back();
    }
    return true;
}

std::string entry_of(const Pictures& pictures, std::size_t index) {
    if (pictures.layers.size() == 1) return layer_picture(0);
    return index == 0 ? "data/canvas.png" : layer_picture(index - 1);
}

}  // namespace

std::optional<Pictures> pictures_of(const PaintingState& painting, int longest_px,
                                    core::ThreadPool& pool, const files::KeepGoing& keep_going) {
    const int factor = coarseness(painting.value.film.shape, longest_px);
    Pictures pictures;
    if (!document::is_single(painting.value.layers)) {
        if (!add_layer_pictures(painting, factor, pool, keep_going, pictures)) return std::nullopt;
    } else {
        pictures.merged = picture_of(painting.value.film, factor, pool);
        pictures.layers = {{painting.value.layers.layers[0].look.name,
                            true,
                            pigment::encode_srgb8(pictures.merged),
                            {}}};
    }
    pictures.px_per_mm = pictures.merged.width / painting.value.bare->settings.width_mm;
    return pictures;
}

Pictures pictures_of(const PaintingState& painting, core::ThreadPool& pool) {
    return *pictures_of(painting, kLongestPicture_px, pool, [](double) { return true; });
}

std::string thumbnail_file(const PaintingState& painting, core::ThreadPool& pool) {
    const document::Painting seen(painting, pool);
    return files::png_file(pigment::encode_srgb8(thumbnail_of(picture_of(
        seen.snapshot().film, coarseness(seen.snapshot().film.shape, kLongestPicture_px), pool))));
}

std::string layer_picture(std::size_t place) {
    return "data/layer" + std::to_string(place) + ".png";
}

std::vector<PictureFile> picture_files(const Pictures& pictures) {
    const auto merged = [&pictures, made = std::make_shared<std::string>()] {
        if (made->empty())
            *made = files::png_file(pigment::encode_srgb8(pictures.merged), pictures.px_per_mm);
        return *made;
    };
    std::vector<PictureFile> files = {{"mergedimage.png", merged}};
    if (pictures.layers.size() == 1) files.push_back({layer_picture(0), merged});
    for (std::size_t i = 0; pictures.layers.size() > 1 && i < pictures.layers.size(); ++i)
        files.push_back({entry_of(pictures, i), [&pictures, i] {
                             const LayerPicture& layer = pictures.layers[i];
                             return files::png_file(layer.picture, pictures.px_per_mm, layer.covered);
                         }});
    files.push_back({"Thumbnails/thumbnail.png", [&pictures] {
                         return files::png_file(pigment::encode_srgb8(thumbnail_of(pictures.merged)));
                     }});
    return files;
}

std::string stack_xml(const Pictures& pictures) {
    std::vector<StackLayer> layers;
    for (std::size_t i = pictures.layers.size(); i-- > 0;)
        layers.push_back({pictures.layers[i].name, entry_of(pictures, i), pictures.layers[i].visible});
    return stack_xml(pictures.merged.width, pictures.merged.height, pictures.px_per_mm, layers);
}

std::string load_thumbnail(const std::filesystem::path& path, int longest_px) {
    const std::string file = load_thumbnail(path);
    const pigment::Picture picture = files::decode_png(file);
    if (std::max(picture.width, picture.height) <= longest_px) return file;
    return files::png_file(pigment::encode_srgb8(thumbnail_of(linear_of(picture), longest_px)));
}

}  // namespace pastoso::project
