// How thick the paint lies that a tool lays.
#pragma once

#include "brush/preset.hpp"

namespace pastoso::brush {

/// How much of its film an element of a tip still leaves, 0 empty to 1 full (above 1 when it spills). It
/// keeps most of it until little paint is left:
///
///     s = (1 + c) fill / (fill + c),   c = 0.22
inline float saturation(float fill) {
    constexpr float kStarvation = 0.22F;
    return (1.0F + kStarvation) * fill / (fill + kStarvation);
}

/// The film, mm, that a full tool leaves: its preset's. A blade can't hold up more than it is wide: that
/// of a knife is an eighth of its width at most.
double full_film_mm(const Preset& preset);

/// The wet film, mm, that a tool lays which is filled to `fill` (0 to 1.2) of its capacity and lightly
/// pressed: film s^2 of one that touches the canvas; of drops, the mean thickness s a / 2 of the cap
/// that one of mean volume forms (droplets.hpp), however full the bottle is. 0 for air.
double laid_film_mm(const Preset& preset, double fill);

}  // namespace pastoso::brush
