// What a painter says of a paint: stiff or runny, short or long, opaque or transparent.
#pragma once

#include "film/medium.hpp"
#include "tools/feel.hpp"

namespace pastoso::tools {

enum class Feel { StiffToRunny, ShortToLong, OpaqueToTransparent };

/// The numbers that it moves; the first tells where a medium stands.
std::span<const FeelNumber<film::Medium>> numbers_of(Feel feel);

/// Where the medium stands, 0 to 1: there the first number is its own, or nearest to it.
double place_of(const film::Medium& medium, Feel feel);

/// The medium at another place. Its numbers go towards those of the end that it moves to, and have come
/// to them there; what lies beside the way between both ends comes to it by and by. No other number
/// changes.
film::Medium with_place(film::Medium medium, Feel feel, double place);

}  // namespace pastoso::tools
