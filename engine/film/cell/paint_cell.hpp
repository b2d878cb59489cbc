// What the paint of a cell carries with it wherever it flows or is brushed: its colour and its
// consistency.
#pragma once

#include "pigment/bands.hpp"

#include <array>
#include <cstdint>

namespace pastoso::film {

struct Medium;

/// K_k h in channels 0..5 and S_k h in 6..11, then what the paint's medium brings along. A channel holds
/// (property per volume) x (thickness), an amount that adds up when paints meet: the properties of a
/// mixture are the means by volume. All channels are >= 0.
inline constexpr int kPigmentChannels = pigment::kChannels;
inline constexpr int kPaintChannels = 16;

/// h ln(nu / kThinnest_m2_s), mm: the viscosities of a mixture's parts multiply, each with its share as
/// exponent (Arrhenius' rule of 1887, still the common one for oils).
inline constexpr int kViscosityChannel = 12;
/// h tau_y, mm Pa.
inline constexpr int kYieldChannel = 13;
/// The thickness that stays when the paint is dry, mm.
inline constexpr int kSolidsChannel = 14;
/// The time that the cell's paint still needs until it is touch-dry, hours: in proportion to the
/// thickness, so that thin paint dries first.
inline constexpr int kDryingChannel = 15;

inline constexpr double kThinnest_m2_s = 1e-6;

/// The quantum of every channel; at most 16384 units a cell.
inline constexpr double kPaintQuantum = 0x1p-17;

/// The channels of a cell, in quanta.
using PaintCell = std::array<std::int32_t, kPaintChannels>;

/// What a paint carries per millimetre of thickness (or per mm3 and mm2), in the same order.
using PaintCoefficients = std::array<float, kPaintChannels>;

/// Fresh paint: a medium with its share of a full-strength paint, whose K and S `pigment` gives.
PaintCoefficients paint_coefficients(const pigment::Coefficients& pigment, const Medium& medium);

/// The optical thickness K h or S h (no unit) of a pigment channel.
inline constexpr float optical_thickness(std::int32_t quanta) {
    return static_cast<float>(quanta) * static_cast<float>(kPaintQuantum);
}

}  // namespace pastoso::film
