// The jug that milk is poured from, as it is drawn: a small bottle of glazed clay, held over the right
// side of the glass.
#pragma once

#include "liquid/surface/turned_mesh.hpp"
#include "liquid/tea/milk_stream.hpp"

#include <span>

#include <glm/vec3.hpp>

namespace pastoso::liquid {

/// How the jug lies: its mouth, and the axis from there to its bottom.
struct JugPlace {
    glm::vec3 mouth_m, axis;
};
/// Steep enough to pass over the rim.
JugPlace jug_place(const MilkStream& stream, const Cup& cup);

/// From the mouth's inner edge to the middle of the bottom; heights are along the axis.
std::span<const TurnedPoint> jug_profile();

/// Where milk stands in the mouth: a disc across the axis.
inline constexpr float kJugMilkRadius_m = 0.0078F, kJugMilkDepth_m = 0.0015F;

/// Whether the jug is still there: once it is taken away, the rest of its stream falls.
inline bool is_held(const MilkStream& stream) {
    return stream.high_m >= stream.lip_m;
}

}  // namespace pastoso::liquid
