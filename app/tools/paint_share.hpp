// Paint : medium, the share of paint in what thins it, as a painter turns it: from paste to stain.
#pragma once

#include "tools/hand.hpp"

namespace pastoso::tools {

/// Of a thin wash for a first lay-in.
inline constexpr double kWashShare = 0.08;

/// What paint of that body is like, from the stiffest to the most fluid.
enum class Body { Paste, Cream, Milk, Wash, Stain };

/// By its viscosity: at least 0.025, 3e-4, 1.5e-5 and 4e-6 m2/s, and less. Oil from the tube goes
/// through all of them as it is thinned.
Body body_of(const film::Medium& medium);

/// So many steps towards more medium, or towards more paint where `steps` is negative: eight to a tenth
/// of the paint, within the limits of film::thinned().
double stepped_paint_share(double share, int steps);

/// Whether something thins the medium in hand.
bool can_thin(const Hand& hand);

/// The numbers of the medium in hand before it is thinned.
film::Medium unthinned_medium(const Hand& hand);

}  // namespace pastoso::tools
