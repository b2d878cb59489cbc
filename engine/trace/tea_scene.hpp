// The picture of a glass of milk tea at one moment.
#pragma once

#include "grid/block_field.hpp"
#include "liquid/tea/milk_stream.hpp"
#include "trace/scene.hpp"

namespace pastoso::trace {

/// How milk that has not dissolved is drawn.
enum class MilkBody {
    Medium,   ///< as a share of the liquid, like milk that has dissolved (liquid::MilkDensities)
    Surface,  ///< as a dull body around the parcels (liquid::MilkSurfaces)
};

/// Of the jug's blue glaze.
inline constexpr glm::vec3 kJugReflectance{0.10F, 0.16F, 0.27F};

/// How a stream dents a level: not at all before it has arrived.
LevelDent stream_dent(const liquid::MilkStream& stream, float level_m);

/// The usual table, light and camera, and in the cup, filled as it is seen, the milk: its share of the
/// liquid, and its body, empty where all of it is in the share. Streams in the air, and the jugs that
/// they come from, are bodies, and the level is dented where streams meet it.
Scene tea_scene(const liquid::Cup& cup, const liquid::SeenPour& pour, grid::BlockField milk_share,
                liquid::TriangleMesh milk = {});

}  // namespace pastoso::trace
