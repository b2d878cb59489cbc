// The picture of a glass of milk tea at one moment.
#pragma once

#include "liquid/cup.hpp"
#include "liquid/tea_frame.hpp"
#include "trace/scene.hpp"

namespace pastoso::trace {

/// The usual table, light and camera, and in the cup what the frame holds; `milk` is the surface of its
/// parcels (liquid::MilkSurfaces).
Scene tea_scene(const liquid::Cup& cup, const liquid::TeaFrame& frame, liquid::TriangleMesh milk);

}  // namespace pastoso::trace
