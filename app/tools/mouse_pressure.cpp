#include "tools/mouse_pressure.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace pastoso::tools {
namespace {

/// Long enough for a steady line, short enough for a flick to thin out within a centimetre or two.
constexpr double kTimeConstant_s = 0.06;

/// At this speed, that of an easy stroke, half of what speed can take away is gone.
constexpr double kEasySpeed_px_s = 700.0;

constexpr double kLightest = 0.25;

}  // namespace

void MousePressure::moved_to(const glm::dvec2& place_px, std::uint64_t time_ms) {
    if (!started_ || time_ms < time_ms_) {
        *this = {};
        started_ = true;
        place_px_ = place_px;
        time_ms_ = time_ms;
        return;
    }
    way_px_ += glm::distance(place_px_, place_px);
    place_px_ = place_px;
    if (time_ms == time_ms_) return;
    const double seconds = 1e-3 * static_cast<double>(time_ms - time_ms_);
    speed_px_s_ += (way_px_ / seconds - speed_px_s_) * -std::expm1(-seconds / kTimeConstant_s);
    way_px_ = 0.0;
    time_ms_ = time_ms;
}

double MousePressure::pressure(const MouseSettings& mouse) const {
    if (!mouse.by_speed) return mouse.pressure;
    const double slowness = 1.0 / (1.0 + speed_px_s_ / kEasySpeed_px_s);
    return mouse.pressure * (kLightest + (1.0 - kLightest) * slowness);
}

}  // namespace pastoso::tools
