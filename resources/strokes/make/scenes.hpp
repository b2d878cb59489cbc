// The recordings that come with the program.
#pragma once

#include "document/events.hpp"

namespace pastoso::examples {

/// An evening by a river in seven steps, from the ground to a glaze, each of kEveningStep_s; the manual
/// shows the state after each.
document::Recording evening_by_a_river();
inline constexpr double kEveningStep_s = 24.0;

/// Mixtures made on the mixing well, by knife and brush, and carried to the canvas.
document::Recording palette();

/// A meadow with poppies below two cypresses, upright: thin ground, thick petals.
document::Recording poppies();

/// What the brushes do: loaded and dry strokes, wet crossings, a knife, swells, dabs and double loads.
document::Recording sampler();

/// What every tool does, field by field: the reference sheet.
document::Recording sheet();

/// A bowl with two pears, a lemon and an apple on a cloth, painted wet in wet.
document::Recording still_life();

/// A wave that breaks before a low sun, with thick foam.
document::Recording surf();

}  // namespace pastoso::examples
