// The cloth that a canvas is of: where on it the canvas lies, and what is woven there.
#pragma once

#include "core/orientation.hpp"
#include "core/thread_pool.hpp"
#include "document/canvas_settings.hpp"
#include "film/support/support.hpp"
#include "layers/transform.hpp"

namespace pastoso::document {

/// The nearest whole cell of a place on the cloth, and where that is.
int cells_from_origin(double place_mm, double px_per_mm);
double on_whole_cells(double place_mm, double px_per_mm);

/// A cloth's longest and shortest step on the canvas, of all that are 1 long on the cloth.
struct DrawnOut {
    double most = 1.0, least = 1.0;
};
DrawnOut drawn_out(const ClothMap& map);

/// As if it were turned by an angle, clockwise.
ClothMap cloth_turned_by(double angle_deg);

/// Heights of the canvas's support, which is a cloth of that name: woven anew in one of eight ways
/// round. Where it has been turned by other angles or drawn out, they are means over the canvas's cells
/// of it woven straight, in levels. Throws InputError where there is no such name.
film::SupportHeights heights_of_cloth(const CanvasSettings& settings, core::ThreadPool& pool,
                                      film::SupportForm form = film::SupportForm::Levels);

/// Of a canvas that is turned about the origin of its cloth, the cloth with it; its sides stay as they
/// are.
CanvasSettings with_turned_cloth(const core::Orientation& turn, CanvasSettings settings);

/// Drawn out by factors from the canvas's own corner, which an image is by itself; its sides and its
/// cells stay as they are.
CanvasSettings with_drawn_out_cloth(double scale_x, double scale_y, CanvasSettings settings);

/// Turned by any angle, clockwise. The place of the cloth that lay in one middle lies in the other.
CanvasSettings with_rotated_cloth(double turn_deg, const layers::Place& middle_before,
                                  const layers::Place& middle_after, CanvasSettings settings);

}  // namespace pastoso::document
