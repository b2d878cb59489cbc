// Which arithmetic strokes are computed with. The same actions give the same bits by the same arithmetic
// alone; recordings say which one they were painted with.
#pragma once

#include "core/message.hpp"

namespace pastoso::document {

/// 1: footprints are looked at in the middles of cells. 2: what a cell gets is a mean over it
/// (brush/resolved_tip.hpp). 3: wet paint on wet paint lies above it (film/cell/lower_stratum.hpp).
/// 4: the film's laws are the same in every direction and at every step length (decision 0067). 5: how
/// long paint waits for its step goes by millimetres where cells are fine (film/tile_activity.hpp). 6:
/// paint lies in layers only where it is told apart by more than rounding (brush/transfer_kernels.cpp).
/// 7: tips that are wider than 60 mm have more bristles, and the marks of rollers end straight
/// (brush/preset.cpp, brush/tip.cpp); the cloth is drawn out with a painting that is scaled (cloth.hpp);
/// paint that is moved or laid from elsewhere keeps off what is masked (layered_canvas.cpp).
inline constexpr int kArithmetic = 7;

/// What a painter should know of strokes of an earlier arithmetic, as the end of a sentence on them;
/// empty for those of the present one.
core::Message arithmetic_note(int arithmetic);

}  // namespace pastoso::document
