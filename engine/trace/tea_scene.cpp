#include "trace/tea_scene.hpp"

#include "liquid/tea/jug_shape.hpp"
#include "liquid/tea/milk_density.hpp"
#include "liquid/tea/milk_surface.hpp"
#include "liquid/tea/stream_mesh.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::trace {
namespace {

/// Of a stream's radius at the level.
constexpr float kDentDepth = 0.5F, kDentRadius = 2.2F;

}  // namespace

LevelDent stream_dent(const liquid::MilkStream& stream, float level_m) {
    const float radius_m = stream.radius_m(level_m);
    const bool arrived = liquid::has_arrived(stream, level_m);
    const float depth_m =
        arrived ? std::min(kDentDepth * radius_m, 0.5F * liquid::kStreamInTea_m) : 0.0F;
    return {stream.at_m, depth_m, kDentRadius * radius_m};
}

Scene tea_scene(const liquid::Cup& cup, const liquid::SeenPour& pour, grid::BlockField milk_share,
                liquid::TriangleMesh milk) {
    Scene scene;
    scene.cup = liquid::cup_in(pour, cup);
    scene.milk = std::move(milk);
    scene.milk_share = std::move(milk_share);
    scene.optics.solid_reflectance = kJugReflectance;
    for (const liquid::MilkStream& stream : pour.streams) {
        const float level_m = scene.cup->level_m;
        liquid::add_stream(stream, level_m, scene.milk);
        if (liquid::is_held(stream)) liquid::add_jug(stream, *scene.cup, scene.solids, scene.milk);
        scene.dents.push_back(stream_dent(stream, level_m));
    }
    return scene;
}

Scene tea_scene(const liquid::TeaSettings& settings, std::span<const liquid::Parcel> parcels,
                const grid::BoxField& dissolved, const liquid::SeenPour& pour, MilkBody body,
                core::ThreadPool& pool) {
    const liquid::Cup cup = liquid::cup_in(pour, settings.cup);
    if (body == MilkBody::Medium)
        return tea_scene(
            cup, pour,
            liquid::MilkDensities(pool).make(parcels, dissolved, cup, liquid::even_density(settings)));
    return tea_scene(cup, pour, grid::BlockField(dissolved),
                     liquid::MilkSurfaces(pool).make(parcels, cup, dissolved.shape()).mesh);
}

}  // namespace pastoso::trace
