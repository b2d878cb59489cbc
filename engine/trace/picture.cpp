#include "trace/picture.hpp"

#include <algorithm>

namespace pastoso::trace {

Picture toned(const Picture& radiance) {
    Picture picture = radiance;
    for (float& value : picture.rgb) {
        const float v = 0.95F * std::max(value, 0.0F);
        value = std::min(1.25F * v * (1.0F + 0.12F * v) / (1.0F + 0.55F * v), 1.0F);
    }
    return picture;
}

}  // namespace pastoso::trace
