#include "io/traced_picture.hpp"

#include "io/image.hpp"
#include "io/picture_file.hpp"

#include <utility>

namespace pastoso::io {

shade::LinearImage shown_image(const trace::Picture& radiance) {
    trace::Picture shown = trace::toned(radiance);
    return {shown.width, shown.height, std::move(shown.rgb), pigment::WorkingSpace::Srgb};
}

void check_traced_path(const std::filesystem::path& path) {
    check_image_path(path);
    check_picture_path(path, {});
}

void write_traced_picture(const std::filesystem::path& path, const trace::Picture& radiance) {
    if (is_linear_format(path))
        write_picture(path, {radiance.width, radiance.height, radiance.rgb, pigment::WorkingSpace::Srgb},
                      {});
    else
        write_picture(path, shown_image(radiance), {});
}

}  // namespace pastoso::io
