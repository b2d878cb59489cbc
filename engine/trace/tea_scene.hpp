// The picture of a glass of milk tea at one moment.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/block_field.hpp"
#include "grid/box_field.hpp"
#include "liquid/tea/milk_stream.hpp"
#include "liquid/tea/parcel.hpp"
#include "liquid/tea/tea_settings.hpp"
#include "trace/scene.hpp"

#include <span>

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

/// The same of parcels and of the share of milk that has dissolved, `dissolved`, at the middles of
/// cells.
Scene tea_scene(const liquid::TeaSettings& settings, std::span<const liquid::Parcel> parcels,
                const grid::BoxField& dissolved, const liquid::SeenPour& pour, MilkBody body,
                core::ThreadPool& pool);

}  // namespace pastoso::trace
