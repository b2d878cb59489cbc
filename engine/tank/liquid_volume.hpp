// The volume of the liquid that a level set holds.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"

namespace pastoso::tank {

/// The volume of {phi < 0} within the box, phi being linear in each of six tetrahedra between eight
/// neighbouring cells' middles. Exact where phi is linear, second order elsewhere. One sample around the
/// box is read.
double liquid_volume_m3(const grid::BoxField& phi, core::ThreadPool& pool);

}  // namespace pastoso::tank
