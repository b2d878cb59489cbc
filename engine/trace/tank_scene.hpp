// The picture of a glass tank of clear liquid, milk and solids at one moment.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/surface/triangle_mesh.hpp"
#include "trace/scene.hpp"

namespace pastoso::trace {

/// A picture of `aspect` (width over height, > 0) shows the whole tank, from a little above. A tank of
/// any size is drawn as a model that stands on a table, kTankModel_m long: light in liquid would
/// otherwise make large tanks dark. The liquid's absorption is that of water, made stronger.
///
/// The box begins at the origin. `milk`: the share of it in the liquid, in the cells of
/// the box. `liquid` and `solids` are closed meshes that reach a little into the glass, at most
/// kTankOverlap_cells of a cell, the liquid into the solids, too.
Scene tank_scene(const grid::BoxField& milk, liquid::TriangleMesh liquid, liquid::TriangleMesh solids,
                 float aspect);
inline constexpr float kTankOverlap_cells = 0.25F;
inline constexpr float kTankModel_m = 0.3F;  ///< the longest side of the box

/// The same tank as it stands, before it becomes a model: how thick its plates are, how much its clear
/// liquid absorbs along a metre, and how many metres of the model are one of the box.
float tank_wall_m(const grid::BoxShape& box);
glm::vec3 tank_absorption_per_m(const grid::BoxShape& box);
float tank_model_scale(const grid::BoxShape& box);

}  // namespace pastoso::trace
