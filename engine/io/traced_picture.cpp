#include "io/traced_picture.hpp"

#include "io/image.hpp"
#include "io/picture_file.hpp"

#include <utility>

namespace pastoso::io {

void check_traced_path(const std::filesystem::path& path) {
    check_image_path(path);
    check_picture_path(path, {});
}

void write_traced_picture(const std::filesystem::path& path, const trace::Picture& radiance) {
    trace::Picture shown = is_linear_format(path) ? radiance : trace::toned(radiance);
    write_picture(path, {shown.width, shown.height, std::move(shown.rgb), pigment::WorkingSpace::Srgb},
                  {});
}

}  // namespace pastoso::io
