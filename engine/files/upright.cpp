#include "files/upright.hpp"

#include <array>

namespace pastoso::files {
namespace {

/// What makes a picture of each orientation upright, from 1 on.
constexpr std::array<core::Orientation, 8> kUpright = {
    {{false, 0}, {true, 0}, {false, 2}, {true, 2}, {true, 3}, {false, 1}, {true, 1}, {false, 3}}};

}  // namespace

pigment::Picture upright(pigment::Picture picture, int orientation) {
    if (orientation < 2 || orientation > 8) return picture;
    return pigment::turned(picture, kUpright[static_cast<std::size_t>(orientation - 1)]);
}

}  // namespace pastoso::files
