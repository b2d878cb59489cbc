// Where wet paint ends within cells: what an enlarged picture needs to draw an outline that is as smooth
// as the relief inside it (docs/decisions/0068-outline.md).
#pragma once

#include "film/state.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pastoso::shade {

/// The narrowest transition of coverage, per cell: less steep ones are no outlines.
inline constexpr float kLeastCoverSlope = 0.1F;

/// The share of a sample that lies within the outline. `cover` is the spline through wet_share() - 1/2,
/// with its gradient per cell; the sample is `width_cells` wide.
[[gnu::always_inline]] inline float share_within(float cover, float slope_x, float slope_y,
                                                 float width_cells) {
    const float slope = std::sqrt(slope_x * slope_x + slope_y * slope_y);
    const float share =
        0.5F + cover / ((slope > kLeastCoverSlope ? slope : kLeastCoverSlope) * width_cells);
    return share < 0.0F ? 0.0F : share > 1.0F ? 1.0F : share;
}

/// How much higher than it is the dry side receives shadows beside an outline, in cells: how high a rim
/// stands is known from cells, and from less than this no shadow can be told. Nothing where the cover is
/// -1/2.
[[gnu::always_inline]] inline float rim_cells(float cover) {
    const float near = 1.0F + 2.0F * cover;
    return 0.25F * (near < 0.0F ? 0.0F : near > 1.0F ? 1.0F : near);
}

/// The sharpness of an edge between cells: the mean of edge_sharpness(), given the sums of their shares
/// and of their sharpness times their share. Where there is no paint nothing of it is seen.
[[gnu::always_inline]] inline float sharpness(float share, float sharp) {
    constexpr float kNoShare = 1e-5F;
    const float mean = sharp / (share > kNoShare ? share : kNoShare);
    return share > kNoShare && mean < 1.0F ? mean : 1.0F;
}

/// How much of the outline is drawn at so many pixels per cell: nothing up to one, where a pixel has
/// room for no more than the cell's own colour, and all of it from two.
inline float outline_strength(double scale) {
    return static_cast<float>(std::clamp(scale - 1.0, 0.0, 1.0));
}

/// How sharply the edge of wet paint is seen at each cell, 0 to 1, by how well the nine cells around and
/// with it hide what lies below them: with a the most of sqrt(K (K + 2 S)) h in a cell and a band, which
/// light loses on its way through (Kubelka and Munk), 0 up to a = 1/2, 1 from 3/2. Thinner paint is as
/// much paler as it is thinner, so that its colours alone show where it ends, and as softly as it thins
/// out.
void edge_sharpness(const film::FilmState& film, const grid::Rect& cells, float* out, int stride);

/// Where the layers of an outline go, row by row; outline.cpp says how they are told.
struct OutlineCells {
    float* share;  ///< of the cell that wet paint covers, 0 to 1
    float* cover;  ///< B-spline coefficients of what is 0 on the outline: gain times share, less 1/2
    std::uint8_t* near;  ///< whether dry and wet meet among the 4 x 4 cells that begin here
};

/// Sets them for a rectangle of cells; `stride` values from row to row. Of cells beyond the canvas as in
/// all of shade.
void outline_cells(const film::FilmState& film, const grid::Rect& cells, const OutlineCells& out,
                   int stride);

}  // namespace pastoso::shade
