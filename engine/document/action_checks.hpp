// What is refused before it reaches the paint: unknown names and values out of range.
#pragma once

#include "brush/preset.hpp"
#include "document/events.hpp"

namespace pastoso::document {

/// The pen may leave the canvas, but not by more than this.
inline constexpr double kMaxPenPosition_mm = 20000.0;

/// A symmetry has at most this many copies beside their mirror images.
inline constexpr int kMostCopies = 16;

/// A transform scales by this along an axis, mirroring aside: what is smaller is not to be seen; larger,
/// a cell would fill a small canvas.
inline constexpr double kLeastScale = 0.05, kMostScale = 20.0;

/// A second of paint time lasts at most this many seconds of drying.
inline constexpr double kFastestDrying = 1e5;

/// The preset that a brush is taken of: its own definition, or the bundled one of that name. Throws
/// InputError as brush::parse_preset() and brush::find_preset() do.
brush::Preset preset_of(const TakeBrush& take);

/// The numbers of a medium in hand. Throws InputError as film::find_medium() does.
film::Medium medium_of(const UseMedium& use);

/// Throws InputError for an unknown brush, paint or medium, or for a value that is not finite or
/// outside the range that events.hpp gives. The message names the value and says nothing of where it
/// came from.
void check_action(const Action& action);

/// The same for one pen sample.
void check_sample(const brush::PenSample& sample);

/// Throws InputError when `next` is earlier than `previous`.
void check_time_order(const brush::PenSample& previous, const brush::PenSample& next);

/// The same as check_action() for a paint alone.
void check_paint(const PaintRecipe& paint);

}  // namespace pastoso::document
