#include "liquid/tea/stream_mesh.hpp"

#include "liquid/tea/jug_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace pastoso::liquid {
namespace {

constexpr int kSegments = 48, kCapRings = 8;
constexpr float kRing_m = 0.001F;  ///< about as far as rings are apart along the stream

/// A quarter of an ellipse: from the axis out to the stream above (`up` -1), or from the stream below to
/// the axis, without the stream's own ring.
void add_cap(float radius_m, float z_m, float up, std::vector<TurnedPoint>& profile) {
    for (int n = up < 0.0F ? 0 : 1; n < kCapRings; ++n) {
        const int from_axis = up < 0.0F ? n : kCapRings - n;
        const float angle = 0.5F * std::numbers::pi_v<float> * static_cast<float>(from_axis) / kCapRings;
        const float out = from_axis == 0 ? 0.0F : std::sin(angle), along = std::cos(angle);
        const glm::vec2 normal = glm::normalize(glm::vec2(kStreamEndHeight * out, up * along));
        profile.push_back({radius_m * out, z_m + up * kStreamEndHeight * radius_m * along, normal});
    }
    if (up > 0.0F) profile.push_back({0.0F, z_m + kStreamEndHeight * radius_m, {0.0F, 1.0F}});
}

/// Adds a profile that turns around the jug's axis.
void add_around_jug(const JugPlace& jug, std::span<const TurnedPoint> profile, TriangleMesh& mesh) {
    const std::size_t first = mesh.positions_m.size();
    add_turned(glm::vec2(0.0F), profile, kSegments, mesh);
    const glm::vec3 level = glm::normalize(glm::cross(glm::vec3(0.0F, 0.0F, 1.0F), jug.axis));
    const glm::mat3 turned(level, glm::cross(jug.axis, level), jug.axis);
    for (std::size_t n = first; n < mesh.positions_m.size(); ++n) {
        mesh.positions_m[n] = jug.mouth_m + turned * mesh.positions_m[n];
        mesh.normals[n] = turned * mesh.normals[n];
    }
}

}  // namespace

void add_jug(const MilkStream& stream, const Cup& cup, TriangleMesh& jug, TriangleMesh& milk) {
    const JugPlace place = jug_place(stream, cup);
    add_around_jug(place, jug_profile(), jug);
    // Closed at the back, within the jug.
    constexpr float kBack_m = kJugMilkDepth_m + 0.001F;
    const std::array<TurnedPoint, 4> disc = {{{0.0F, kJugMilkDepth_m, {0.0F, -1.0F}},
                                              {kJugMilkRadius_m, kJugMilkDepth_m, {0.0F, -1.0F}},
                                              {kJugMilkRadius_m, kBack_m, {0.0F, 1.0F}},
                                              {0.0F, kBack_m, {0.0F, 1.0F}}}};
    add_around_jug(place, disc, milk);
}

void add_stream(const MilkStream& stream, float level_m, TriangleMesh& mesh) {
    const bool arrived = has_arrived(stream, level_m);
    const float low_m = arrived ? level_m - kStreamInTea_m : stream.low_m, high_m = stream.high_m;
    const int rings = 1 + static_cast<int>(std::ceil((high_m - low_m) / kRing_m));
    std::vector<TurnedPoint> profile;
    add_cap(stream.radius_m(low_m), low_m, -1.0F, profile);
    for (int ring = 0; ring <= rings; ++ring) {
        const float z_m =
            low_m + (high_m - low_m) * static_cast<float>(ring) / static_cast<float>(rings);
        const float aside_m = 0.5F * kRing_m;
        const float widens = stream.radius_m(z_m + aside_m) - stream.radius_m(z_m - aside_m);
        profile.push_back({stream.radius_m(z_m), z_m, glm::normalize(glm::vec2(kRing_m, -widens))});
    }
    add_cap(stream.radius_m(high_m), high_m, 1.0F, profile);
    add_turned(stream.at_m, profile, kSegments, mesh);
}

}  // namespace pastoso::liquid
