// The picture of a glass of milk tea at one moment.
#pragma once

#include "grid/block_field.hpp"
#include "liquid/tea/cup.hpp"
#include "trace/scene.hpp"

namespace pastoso::trace {

/// How milk that has not dissolved is drawn.
enum class MilkBody {
    Medium,   ///< as a share of the liquid, like milk that has dissolved (liquid::MilkDensities)
    Surface,  ///< as a dull body around the parcels (liquid::MilkSurfaces)
};

/// The usual table, light and camera, and in the cup the milk: its share of the liquid, and its body,
/// empty where all of it is in the share.
Scene tea_scene(const liquid::Cup& cup, grid::BlockField milk_share, liquid::TriangleMesh milk = {});

}  // namespace pastoso::trace
