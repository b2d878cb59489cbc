#include "liquid/tea/stream_mesh.hpp"

#include "liquid/tea/jug_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr float kLevel_m = 0.08F;

MilkStream stream(float high_m, float low_m) {
    MilkStream stream;
    stream.at_m = {0.04F, 0.06F};
    stream.lip_m = 0.12F;
    stream.high_m = high_m;
    stream.low_m = low_m;
    stream.lip_speed_m_s = 0.2F;
    stream.lip_radius_m = 0.005F;
    return stream;
}

/// The integral of pi r^2 over free fall is exact: pi r0^2 v0 (v_low - v_high) / g.
double fallen_m3(const MilkStream& stream, float low_m) {
    const double flow = std::numbers::pi * static_cast<double>(stream.lip_radius_m) *
                        stream.lip_radius_m * stream.lip_speed_m_s;
    return flow * (stream.speed_m_s(low_m) - stream.speed_m_s(stream.high_m)) / 9.81;
}

/// A cap is half an ellipsoid, 0.7 as high as wide.
double cap_m3(float radius_m) {
    return 2.0 / 3.0 * std::numbers::pi * 0.7 * std::pow(static_cast<double>(radius_m), 3.0);
}

TEST(StreamMesh, HoldsWhatIsInTheAir) {
    for (const float low_m : {0.1F, 0.09F}) {
        const MilkStream falling = stream(0.115F, low_m);
        TriangleMesh mesh;
        add_stream(falling, kLevel_m, mesh);
        const double exact = fallen_m3(falling, low_m) + cap_m3(falling.radius_m(low_m)) +
                             cap_m3(falling.radius_m(falling.high_m));
        // A polygon of 48 corners lacks 0.3 % of a circle, caps of 8 rings some percent of theirs.
        EXPECT_NEAR(volume_m3(mesh), exact, 0.015 * exact);
        EXPECT_LT(volume_m3(mesh), exact);
    }
}

TEST(StreamMesh, ItsNormalsPointOutAsItsTrianglesDo) {
    TriangleMesh mesh;
    add_stream(stream(0.12F, kLevel_m), kLevel_m, mesh);
    ASSERT_EQ(mesh.normals.size(), mesh.positions_m.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const glm::vec3 flat = glm::normalize(glm::cross(mesh.positions_m[b] - mesh.positions_m[a],
                                                         mesh.positions_m[c] - mesh.positions_m[a]));
        // From ring to ring of a cap the normal turns by up to 16 degrees: 11 by 0.7.
        EXPECT_GT(glm::dot(flat, glm::normalize(mesh.normals[a] + mesh.normals[b] + mesh.normals[c])),
                  0.97F);
    }
}

TEST(StreamMesh, GoesOnBelowALevelThatItHasReached) {
    const auto lowest_m = [](const MilkStream& falling) {
        TriangleMesh mesh;
        add_stream(falling, kLevel_m, mesh);
        return std::ranges::min(mesh.positions_m, {}, &glm::vec3::z).z;
    };
    EXPECT_LT(lowest_m(stream(0.12F, kLevel_m)), kLevel_m - kStreamInTea_m);
    EXPECT_GT(lowest_m(stream(0.12F, kLevel_m + 0.006F)), kLevel_m);
}

TEST(Jug, StandsOverTheRimWhereverMilkIsPoured) {
    const Cup cup;
    const float level_radius_m = cup.inner_radius_m(cup.level_m);
    for (const float aside : {-0.9F, -0.4F, 0.0F, 0.3F, 0.6F}) {
        MilkStream pouring = stream(0.0F, 0.0F);
        pouring.at_m = cup.axis_m + glm::vec2(aside * level_radius_m, 0.0F);
        pouring.lip_m = pouring.high_m = cup.level_m + 0.005F;
        EXPECT_TRUE(is_held(pouring));
        TriangleMesh jug, milk;
        add_jug(pouring, cup, jug, milk);
        for (const glm::vec3& at_m : jug.positions_m) {
            if (at_m.z > cup.rim_m) continue;
            const float from_axis_m = glm::distance(glm::vec2(at_m), cup.axis_m);
            EXPECT_LT(from_axis_m, cup.inner_radius_m(at_m.z)) << aside << " at " << at_m.z;
        }
    }
}

}  // namespace
}  // namespace pastoso::liquid
