// How far a ray may go without meeting the surface of a liquid.
#pragma once

#include "liquid/surface/sampled_field.hpp"

namespace pastoso::session {

/// The level (TankFrame::level_m) is known near the surface alone. Here it goes on: with the same sign,
/// at no point farther than the surface is, and about 0.57 times as far at least.
liquid::SampledField far_level(const liquid::SampledField& level_m);

}  // namespace pastoso::session
