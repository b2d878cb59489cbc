// How carefully a part of the window is shaded.
#pragma once

namespace pastoso::screen {

/// In the order of their cost.
enum class Quality {
    Coarse,  ///< one sample for four pixels, where cells are larger than those
    Plain,   ///< one sample a pixel
    Fair,    ///< samples at most a cell apart
    Full,    ///< samples at most half a cell apart, as in a saved picture
};

/// Samples of the surface along a side of a pixel, at this many device pixels per cell.
int samples_per_side(Quality quality, double px_per_cell);

/// Whether large pixels show the surface well enough for a draft. Where cells are smaller, a weave would
/// turn into another one.
bool coarse_is_useful(double px_per_cell);

/// Samples a pixel.
double samples_per_pixel(Quality quality, double px_per_cell);

}  // namespace pastoso::screen
