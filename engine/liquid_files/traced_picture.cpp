#include "liquid_files/traced_picture.hpp"

#include "files/image.hpp"
#include "files/picture_file.hpp"

#include <utility>

namespace pastoso::liquid_files {

pigment::LinearImage shown_image(const trace::Picture& radiance) {
    trace::Picture shown = trace::toned(radiance);
    return {shown.width, shown.height, std::move(shown.rgb), pigment::WorkingSpace::Srgb};
}

void check_traced_path(const std::filesystem::path& path) {
    files::check_image_path(path);
    files::check_picture_path(path, {});
}

void write_traced_picture(const std::filesystem::path& path, const trace::Picture& radiance) {
    if (files::is_linear_format(path))
        files::write_picture(
            path, {radiance.width, radiance.height, radiance.rgb, pigment::WorkingSpace::Srgb}, {});
    else
        files::write_picture(path, shown_image(radiance), {});
}

}  // namespace pastoso::liquid_files
