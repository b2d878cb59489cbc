// How layers are numbered, called and shown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pastoso::document {

/// Layers are numbered from 1 in the order in which they come to be, groups too; a number is never given
/// twice. A layer of the group 0 is in none.
using LayerId = std::uint32_t;
using GroupId = std::uint32_t;

/// More than a painter can tell apart, and few enough to look through all of them.
inline constexpr std::size_t kMostLayers = 100;
inline constexpr std::size_t kMostLayerName = 200;

/// How a layer or a group shows, and whether it can be changed. What a group says holds for all of its
/// layers beside what each of them says.
struct LayerLook {
    std::string name{};  ///< at most kMostLayerName bytes
    bool visible = true;
    bool locked = false;   ///< nothing is painted on it, cleared or merged
    double opacity = 1.0;  ///< of what its paint does to light, 0 to 1; its relief stays
    bool bare_locked = false;  ///< tools change only what of it has paint when they begin
    bool clipped = false;  ///< of a layer: only what lies over the layer below shows (clipping_base())
    friend bool operator==(const LayerLook&, const LayerLook&) = default;
};

}  // namespace pastoso::document
