// How far a ray may go without meeting the surface of a liquid.
#pragma once

#include "liquid/sampled_field.hpp"

namespace pastoso::session {

/// The level (TankFrame::level_m) is known near the surface alone. Here it goes on: with the same sign,
/// at no point farther than the surface is, and no less far than 0.57 times that.
liquid::SampledField far_level(const liquid::SampledField& level_m);

}  // namespace pastoso::session
