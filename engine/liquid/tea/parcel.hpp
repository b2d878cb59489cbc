// A parcel of milk that has not dissolved yet: a small ball that the tea carries along.
#pragma once

#include <glm/vec3.hpp>

namespace pastoso::liquid {

struct Parcel {
    glm::vec3 position_m{0.0F};
    float volume_m3 = 0.0F;
    float coldness = 1.0F;  ///< 1 as it was poured, 0 as warm as the tea
    int ball = -1;          ///< the ball that it rises with, -1: none yet
    friend bool operator==(const Parcel&, const Parcel&) = default;
};

}  // namespace pastoso::liquid
