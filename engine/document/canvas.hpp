// The size of a canvas: in cells, in bytes, and whether this machine can hold it.
#pragma once

#include "core/orientation.hpp"
#include "document/actions/canvas_actions.hpp"
#include "document/canvas_settings.hpp"
#include "film/support/support.hpp"
#include "grid/extent.hpp"
#include "layers/resampling.hpp"
#include "layers/rotation.hpp"

#include <cstddef>
#include <memory>

namespace pastoso::document {

inline constexpr double kMinPxPerMm = 0.25;
inline constexpr double kMaxPxPerMm = 64.0;
/// How far from the origin of its cloth a canvas may begin.
inline constexpr double kMaxClothPlace_mm = 1e5;
/// By how much a cloth may be drawn out, and how much narrowed: twice as far as a painting at a time.
inline constexpr double kMostDrawnOut = kMostCanvasScale * kMostCanvasScale;
inline constexpr int kMaxCellsPerSide = 32768;

/// What there is before anything is painted.
struct BareCanvas {
    CanvasSettings settings;
    film::SupportHeights support_mm;
    /// How far what is painted has been drawn out since the painting was begun or opened, for what lies
    /// over it.
    double drawn_out_x = 1.0, drawn_out_y = 1.0;
    double rotated_deg = 0.0;  ///< how far it has been turned since then by RotateCanvas, clockwise
};

/// Throws InputError when a number is not finite or outside the limits above, or when the support's
/// relief is not in 0 to 20 mm.
void check_canvas(const CanvasSettings& settings);

/// Width and height in cells, rounded to whole cells, at least 1. `settings` passed check_canvas().
grid::Shape canvas_shape(const CanvasSettings& settings);

/// The cells that a canvas of these settings is to have.
grid::Extent extent_of(const ResizeCanvas& resize, const CanvasSettings& settings);

/// What becomes of the settings. Throws InputError as check_canvas() does.
CanvasSettings resized(const ResizeCanvas& resize, CanvasSettings settings);

/// A canvas that is cut or made larger, as it was and as it will be.
struct ResizedCanvas {
    ResizeCanvas resize;
    std::shared_ptr<const BareCanvas> before, after;
};

/// Makes it; the support's heights take the most of that. Throws InputError where there can be no such
/// canvas or it would not fit into memory.
ResizedCanvas resized_canvas(const ResizeCanvas& resize, std::shared_ptr<const BareCanvas> before,
                             core::ThreadPool& pool);

/// What becomes of the settings of a canvas that is turned with its cloth. Throws InputError as
/// check_canvas() does.
CanvasSettings turned(const core::Orientation& turn, CanvasSettings settings);

/// The canvas that has been turned: the heights as they were, each in its new place. Throws the same.
BareCanvas turned(const core::Orientation& turn, const BareCanvas& bare, core::ThreadPool& pool);

/// What becomes of the settings of a canvas that is scaled; it begins on the same place of the cloth, in
/// whole cells. Throws InputError as check_canvas() does.
CanvasSettings scaled(const ScaleCanvas& scale, CanvasSettings settings);

/// Where its cells come to.
layers::Resampling resampling_of(const ScaleCanvas& scale, const CanvasSettings& before);

/// The canvas that has been scaled: of the same cloth, or of its image drawn out. Throws the same, and
/// where it would not fit into memory.
BareCanvas scaled(const ScaleCanvas& scale, const BareCanvas& bare, core::ThreadPool& pool);

/// What becomes of the settings of a canvas on which everything is turned, the cloth with it, which then
/// has a map; an image is no cloth. Throws InputError as check_canvas() does.
CanvasSettings rotated(const RotateCanvas& rotate, CanvasSettings settings);

/// About the middle of the cells that there were, which comes to that of the cells there will be.
layers::Rotation rotation_of(const RotateCanvas& rotate, const CanvasSettings& before);

/// Where its cells come to.
layers::Resampling resampling_of(const RotateCanvas& rotate, const CanvasSettings& before);

/// The canvas on which everything is turned: of the same cloth, or of its image, turned as well. Throws
/// the same, and where it would not fit into memory.
BareCanvas rotated(const RotateCanvas& rotate, const BareCanvas& bare, core::ThreadPool& pool);

/// About what a painting of this many cells needs when all of it is wet and being rendered.
std::size_t estimated_bytes(const grid::Shape& shape);

/// check_canvas(), and an InputError that names the size when the canvas needs more than
/// `available_bytes`.
void check_canvas_fits(const CanvasSettings& settings, std::size_t available_bytes);

}  // namespace pastoso::document
