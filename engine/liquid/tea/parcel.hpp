// A parcel of milk that has not dissolved yet: a small ball that the tea carries along and draws out.
#pragma once

#include <glm/vec3.hpp>

namespace pastoso::liquid {

/// Of a parcel's milk, the covariance of where it lies over that of a parcel as it is poured, which is
/// 1: symmetric, positive definite (parcel_shape.hpp).
struct ParcelShape {
    float xx = 1.0F, yy = 1.0F, zz = 1.0F, xy = 0.0F, xz = 0.0F, yz = 0.0F;
    friend bool operator==(const ParcelShape&, const ParcelShape&) = default;
};

struct Parcel {
    glm::vec3 position_m{0.0F};
    float volume_m3 = 0.0F;
    float coldness = 1.0F;  ///< 1 as it was poured, 0 as warm as the tea
    int ball = -1;          ///< the ball that it rises with, -1: none yet
    ParcelShape shape = {};
    friend bool operator==(const Parcel&, const Parcel&) = default;
};

}  // namespace pastoso::liquid
