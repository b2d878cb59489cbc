// Small scenes for the tests of tracing.
#pragma once

#include "trace/scene.hpp"
#include "trace/tracer.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace pastoso::tests {

/// Adds a closed ball of rings and sectors.
inline void add_ball(liquid::TriangleMesh& mesh, const glm::vec3& middle_m, float radius_m,
                     int rings = 12) {
    const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
    const int sectors = 2 * rings;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i < sectors; ++i) {
            const double polar = std::numbers::pi * j / rings;
            const double turn = 2.0 * std::numbers::pi * i / sectors;
            // At the poles all sectors meet in one point, exactly.
            const double ring = j == 0 || j == rings ? 0.0 : std::sin(polar);
            const glm::vec3 out(ring * std::cos(turn), ring * std::sin(turn), std::cos(polar));
            mesh.positions_m.push_back(middle_m + radius_m * out);
            mesh.normals.push_back(out);
        }
    const auto at = [&](int j, int i) {
        return first + static_cast<std::uint32_t>(j * sectors + i % sectors);
    };
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < sectors; ++i) {
            if (j + 1 < rings) mesh.triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
            if (j > 0) mesh.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
        }
}

/// Milk of this volume fraction in every cell of the cup's box.
inline grid::BoxField even_milk(float fraction, int cells = 16) {
    return grid::BoxField({cells, cells, cells, 0.1F / static_cast<float>(cells)}, fraction);
}

/// A busy glass: balls, a layer on the floor, a cloudy lower half.
inline trace::Scene busy_glass() {
    trace::Scene scene;
    add_ball(scene.milk, {0.05F, 0.04F, 0.05F}, 0.008F);
    add_ball(scene.milk, {0.06F, 0.06F, 0.075F}, 0.006F);
    add_ball(scene.milk, {0.035F, 0.05F, 0.015F}, 0.009F);
    grid::BoxField share = even_milk(0.0F);
    for (int k = 0; k < 8; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
                share.at(i, j, k) = 0.02F * static_cast<float>(8 - k) / 8.0F;
    scene.milk_share = grid::BlockField(share);
    return scene;
}

/// A tank of glass plates, 0.1 m along each side, with liquid up to `top_m` that ends in the middle of
/// the plates; no table.
inline trace::Scene full_tank(float top_m) {
    trace::Scene scene;
    scene.cup.reset();
    scene.table.reset();
    scene.tank = trace::Tank{};
    const float low = -0.001F, high = 0.101F;
    auto& mesh = scene.clear_liquid;
    for (const float z : {low, top_m})
        for (const float y : {low, high})
            for (const float x : {low, high})
                mesh.positions_m.push_back({x, y, z});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return scene;
}

/// No light but an even sky of radiance 1.
inline void put_into_furnace(trace::Scene& scene) {
    scene.lamp.reset();
    scene.sky.below = scene.sky.above = glm::vec3(1.0F);
    scene.sky.window_radiance = glm::vec3(0.0F);
    scene.optics.tea_absorption_per_m = scene.optics.glass_absorption_per_m = glm::vec3(0.0F);
    scene.optics.milk_albedo = scene.optics.milk_reflectance = scene.optics.solid_reflectance =
        glm::vec3(1.0F);
    if (scene.table) {
        scene.table->reflectance = glm::vec3(1.0F);
        scene.table->fading_to = 1.0F;
        scene.table->is_wood = false;
    }
}

inline trace::TraceSettings small_picture(int side) {
    trace::TraceSettings settings;
    settings.width = settings.height = side;
    return settings;
}

inline double mean_of(const trace::Picture& picture) {
    double sum = 0.0;
    for (const float value : picture.rgb)
        sum += value;
    return sum / static_cast<double>(picture.rgb.size());
}

}  // namespace pastoso::tests
