#include "tools/paint_share.hpp"

#include "document/actions/actions.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::tools {

Body body_of(const film::Medium& medium) {
    struct Least {
        Body body;
        double viscosity_m2_s;
    };
    constexpr Least kLeast[] = {
        {Body::Paste, 0.025}, {Body::Cream, 3e-4}, {Body::Milk, 1.5e-5}, {Body::Wash, 4e-6}};
    for (const Least& least : kLeast)
        if (medium.viscosity_m2_s >= least.viscosity_m2_s) return least.body;
    return Body::Stain;
}

/// Whole percents where one is small beside a step, and the ends themselves.
double stepped_paint_share(double share, int steps) {
    constexpr double kStepsPerTenth = 8.0;
    const double stepped = share * std::pow(10.0, -steps / kStepsPerTenth);
    const double per_one = stepped < 0.1 ? 1000.0 : 100.0;
    return std::clamp(std::round(per_one * stepped) / per_one, film::kLeastPaintShare, 1.0);
}

bool can_thin(const Hand& hand) {
    return !unthinned_medium(hand).thinned_with.empty();
}

film::Medium unthinned_medium(const Hand& hand) {
    return document::medium_of({hand.medium.name, hand.medium.own});
}

}  // namespace pastoso::tools
