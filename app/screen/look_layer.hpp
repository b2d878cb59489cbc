// The thicknesses that some looks show, as the shader's texture holds them.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "screen/look.hpp"

#include <vector>

namespace pastoso::screen {

struct LookPatch {
    grid::Rect cells;
    std::vector<float> thickness_mm;  ///< row by row
};

/// Whether a look shows thicknesses of its own.
bool needs_thickness(Look look);

/// The thickness that a look shows of a cell on the canvas.
float look_thickness_mm(const document::Snapshot& painting, Look look, int x, int y);

/// Of these tiles, with the border where they lie at the canvas's edge: for Look::Wet the wet paint, for
/// Look::Height all paint above the bare canvas. Cells beyond the canvas have the value of the nearest.
std::vector<LookPatch> look_patches(const document::Snapshot& painting, Look look,
                                    const std::vector<int>& tiles, core::ThreadPool& pool);

double highest_mm(const std::vector<LookPatch>& patches);

}  // namespace pastoso::screen
