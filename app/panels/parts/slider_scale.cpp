#include "panels/parts/slider_scale.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::panels {

double SliderScale::value_at(int step) const {
    const double share = step / double{kSteps};
    if (logarithmic) return least * std::pow(most / least, share);
    return std::lerp(least, most, share);
}

int SliderScale::step_of(double value) const {
    const double inside = std::clamp(value, least, most);
    const double share = logarithmic ? std::log(inside / least) / std::log(most / least)
                                     : (inside - least) / (most - least);
    return static_cast<int>(std::lround(kSteps * share));
}

}  // namespace pastoso::panels
