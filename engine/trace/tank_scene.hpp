// The picture of a glass tank of clear liquid, milk and solids at one moment.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"
#include "liquid/sampled_field.hpp"
#include "trace/scene.hpp"

namespace pastoso::trace {

/// What is in a tank whose room is a box that begins at the origin.
struct TankContents {
    /// Signed distance from the liquid's surface, negative within. Its points go on beyond the walls and
    /// into solids for at least a quarter of a cell, as if liquid did.
    const liquid::SampledField& level_m;
    const grid::BoxField& milk;          ///< share of milk in the liquid, in the cells of the room
    const liquid::TriangleMesh& solids;  ///< may reach a quarter of a cell beyond the walls
};

/// A picture of `aspect` (width over height, > 0) shows the whole tank, from a little above. A tank of
/// any size is drawn as a model that stands on a table, kTankModel_m long: light in liquid would
/// otherwise make large tanks dark. The liquid's absorption is that of water, made stronger.
Scene tank_scene(const TankContents& contents, float aspect, core::ThreadPool& pool);
inline constexpr float kTankModel_m = 0.3F;  ///< the longest side of the room

/// The liquid's surface, closed, reaching a quarter of a cell beyond walls and floor.
liquid::TriangleMesh tank_liquid_mesh(const liquid::SampledField& level_m, const grid::BoxShape& room,
                                      core::ThreadPool& pool);

}  // namespace pastoso::trace
