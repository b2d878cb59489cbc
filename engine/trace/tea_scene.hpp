// The picture of a glass of milk tea at one moment.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/tea/cup.hpp"
#include "trace/scene.hpp"

namespace pastoso::trace {

/// The usual table, light and camera, and in the cup the milk: what has dissolved, as the share of each
/// cell, and the surface of the parcels (liquid::MilkSurfaces).
Scene tea_scene(const liquid::Cup& cup, grid::BoxField dissolved, liquid::TriangleMesh milk);

}  // namespace pastoso::trace
