// Rows of a multigrid level in checkerboard order, from and to cell by cell: shared by the kernels of
// one instruction set.
#pragma once

#include "film/large/large_tile.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

/// Calls visit(x, y) for the cells along the outside of the canvas' open edges, the only ones there that
/// a face with mobility reaches. No paint answers in them, so that p and d stay zero.
template <class Visit>
void for_each_cell_beyond(const MultigridLevel& level, const Visit& visit) {
    const auto is_inside = [&](int k) { return k >= 0 && k < level.size; };
    for (const int y : {level.within.y0 - 1, level.within.y1})
        for (int x = 0; x < level.size && is_inside(y); ++x)
            visit(x, y);
    for (const int x : {level.within.x0 - 1, level.within.x1})
        for (int y = 0; y < level.size && is_inside(x); ++y)
            visit(x, y);
}

/// Puts row y, given cell by cell, into checkerboard order. `values` points to cell 0.
void split_row(const MultigridLevel& level, int y, const float* values, LevelValues& out) {
    float* even = out.data() + level.row(y, y & 1);
    float* odd = out.data() + level.row(y, 1 - (y & 1));
    for (int k = 0; k < level.half(); ++k) {
        even[k] = values[2 * k];
        odd[k] = values[2 * k + 1];
    }
}
void merge_row(const MultigridLevel& level, int y, const LevelValues& values, float* out) {
    const float* even = values.data() + level.row(y, y & 1);
    const float* odd = values.data() + level.row(y, 1 - (y & 1));
    for (int k = 0; k < level.half(); ++k) {
        out[2 * k] = even[k];
        out[2 * k + 1] = odd[k];
    }
}

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA
