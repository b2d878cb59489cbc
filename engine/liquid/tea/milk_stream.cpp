#include "liquid/tea/milk_stream.hpp"

#include <algorithm>

namespace pastoso::liquid {
double fallen_speed_m_s(double lip_speed_m_s, double way_m) {
    return std::sqrt(lip_speed_m_s * lip_speed_m_s + 2.0 * kFreeFall_m_s2 * way_m);
}

double fallen_way_m(double lip_speed_m_s, double seconds) {
    return seconds * (lip_speed_m_s + 0.5 * kFreeFall_m_s2 * seconds);
}

float MilkStream::speed_m_s(float z_m) const {
    const double way_m = std::max(static_cast<double>(lip_m) - static_cast<double>(z_m), 0.0);
    return static_cast<float>(fallen_speed_m_s(static_cast<double>(lip_speed_m_s), way_m));
}

}  // namespace pastoso::liquid
