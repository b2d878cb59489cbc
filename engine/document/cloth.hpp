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

/// Heights of the canvas's support, which is a cloth of that name: woven anew in one of eight ways
/// round; of one that lies askew, means over the canvas's cells of it woven upright, in levels. Throws
/// InputError where there is no such name.
film::SupportHeights heights_of_cloth(const CanvasSettings& settings, core::ThreadPool& pool,
                                      film::SupportForm form);

/// Of a canvas that is turned about the origin of its cloth, the cloth with it; its sides stay as they
/// are.
CanvasSettings with_turned_cloth(const core::Orientation& turn, CanvasSettings settings);

/// The same by any angle, clockwise. The place of the cloth that lay in one middle lies in the other.
CanvasSettings with_rotated_cloth(double turn_deg, const layers::Place& middle_before,
                                  const layers::Place& middle_after, CanvasSettings settings);

}  // namespace pastoso::document
