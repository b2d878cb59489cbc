// Reliefs that painters give a support before or while they paint: what is laid on, as plain values.
#pragma once

#include "layers/picture_place.hpp"
#include "pigment/image.hpp"

#include <cstdint>
#include <memory>
#include <variant>

namespace pastoso::layers {

/// Sand in a binder: irregular grains, heaped at random, with binder between them.
struct SandTexture {
    double grain_mm = 0.6;   ///< mean diameter of a grain
    std::uint32_t seed = 1;  ///< which grains
    friend bool operator==(const SandTexture&, const SandTexture&) = default;
};

/// Modelling paste spread with a knife: flat passes that overlap, a lip at their edges and where the
/// knife was lifted, ridges along them.
struct KnifedTexture {
    double height_mm = 0.8;      ///< no place is higher
    double spacing_mm = 2.0;     ///< from ridge to ridge; a pass is kRidgesInPass times as broad
    double direction_deg = 0.0;  ///< of the passes: 0 right, 90 down
    std::uint32_t seed = 1;      ///< which passes
    friend bool operator==(const KnifedTexture&, const KnifedTexture&) = default;
};

inline constexpr double kRidgesInPass = 6.0;

/// The relief of a picture pressed in, as through a stencil: nothing where it is black, or clear.
struct PressedTexture {
    PicturePlace place;
    double height_mm = 0.5;                           ///< where it is white
    bool dark_raised = false;                         ///< the other way round: nothing where it is white
    std::shared_ptr<const pigment::Picture> picture;  ///< not null when it is laid
    friend bool operator==(const PressedTexture& a, const PressedTexture& b) {
        return a.place == b.place && a.height_mm == b.height_mm && a.dark_raised == b.dark_raised &&
               (a.picture == b.picture || (a.picture && b.picture && *a.picture == *b.picture));
    }
};

using Texture = std::variant<SandTexture, KnifedTexture, PressedTexture>;

}  // namespace pastoso::layers
