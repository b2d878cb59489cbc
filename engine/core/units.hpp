// Units. The engine speaks in millimetres, seconds and kilograms; names carry the unit (width_mm, yield_Pa).
#pragma once

namespace pastoso::core {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kInch_mm = 25.4;
inline constexpr double kStandardGravity_mm_s2 = 9806.65;

constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

}  // namespace pastoso::core
