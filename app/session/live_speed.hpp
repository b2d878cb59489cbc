// How fine a canvas this machine paints on as fast as the hand moves.
#pragma once

#include "core/thread_pool.hpp"

#include <functional>

namespace pastoso::session {

/// Seconds that a second of painting takes on all processors of `pool`: a flat brush 20 mm wide, full of
/// heavy-body oil, goes to and fro over its own wet paint at 200 mm/s on cells of `px_per_mm` a
/// millimetre. It is measured for half a second of painting, or until that has taken half a second.
double painting_load(double px_per_mm, core::ThreadPool& pool);

/// The finest of 8, 6 and 4 cells a millimetre at which painting takes less than a fifth of its time; 4
/// where none does. A painting that is wet all over takes twice as much (30 s of a pen's hurried strokes
/// 0.75 of theirs where this measures 0.38), and the rest is for the picture, which some machines draw
/// without a graphics card.
double live_px_per_mm(const std::function<double(double px_per_mm)>& load_at);

}  // namespace pastoso::session
