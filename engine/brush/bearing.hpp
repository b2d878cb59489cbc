// What a tool bears on. Stiff hairs sink through wet paint to the dry surface below, each for itself. A
// stiff edge lies on the highest parts of that surface. A blade that is held flat and lightly, and soft
// hairs in a light hand, are carried by the wet paint itself, which has no time to flow out from below:
//
//   d = s + rigidity (s_edge - s),   w = u + rigidity (mean(u) - u),
//   b = d + r max(0, w - d),    r = ride + 3.6 ride (1 - ride) noise in 0..1,
//
// s the dry surface below an element, s_edge that below the edge (brush/bristle_motion.hpp), and u the
// wet surface c + h_0 that the tool found there: what it lays itself does not lift it. A blade comes
// down on a lower surface with a slope, up at once. Between riding and scraping no edge is even: stripes
// of it, narrow ones within wide ones, ride while others scrape, which is what drags one paint into the
// other in streaks. Hairs have no noise: those that ride dip into the paint by the same share of its
// depth, and paint thinner than a hair carries them less: r = ride min(1, (w - d) / 0.05 mm).
#pragma once

#include "brush/bristle_motion.hpp"
#include "brush/pass_map.hpp"

#include <vector>

namespace pastoso::brush {

/// How far a tool is carried by wet paint, 0 to 1.
float ride_of(const FlexPreset& flex, const HandPose& hand);

struct Bearing {
    float rigidity = 0.0F;
    float ride = 0.0F;
    bool is_edge = true;   ///< of a blade; or else hairs
    double tuft_mm = 0.0;  ///< how far from its middle a hair is carried
    float edge_support_mm = 0.0F;
    float sinking_mm = 0.0F;  ///< how far down a blade may come in this step; hairs: any way
    double travel_mm = 0.0;   ///< since the stroke began
    std::uint32_t noise_seed = 0;
};

/// Sets what every element that touches bears on and how far it rides, with `pass` telling what the tool
/// found.
void bear(const Bearing& bearing, const film::FilmState& film, const PassMap& pass,
          std::vector<BristlePose>& poses);

}  // namespace pastoso::brush
