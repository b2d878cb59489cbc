// Milk in the air and the jug that it comes from as meshes.
#pragma once

#include "liquid/surface/triangle_mesh.hpp"
#include "liquid/tea/milk_stream.hpp"

namespace pastoso::liquid {

/// How far a stream is drawn on below a level that it has reached: its dent is not so deep.
inline constexpr float kStreamInTea_m = 0.003F;

/// How high its round ends are, of their radius.
inline constexpr float kStreamEndHeight = 0.7F;

/// Adds the stream, round at the ends that are in the air, with normals.
void add_stream(const MilkStream& stream, float level_m, TriangleMesh& mesh);

/// Adds the jug of a stream, open at the mouth, and the milk that stands there.
void add_jug(const MilkStream& stream, const Cup& cup, TriangleMesh& jug, TriangleMesh& milk);

}  // namespace pastoso::liquid
