// The paint's surface: support plus wet paint, as a smooth function of position.
#pragma once

#include "film/state.hpp"

#include <vector>

namespace pastoso::shade {

/// Mean height of the surface over each cell of a rectangle, c + h in mm, row by row; `stride` floats
/// from row to row. Here as in all of shade, cells beyond the canvas have the value of the nearest on
/// it.
void surface_means(const film::FilmState& film, const grid::Rect& cells, float* out, int stride);

/// Thickness of the wet paint alone, the same way.
void thickness_means(const film::FilmState& film, const grid::Rect& cells, float* out, int stride);

/// The coefficients of the cubic B-spline (grid/bspline.hpp) that has these means, in mm, the same way.
/// Those of the paint are kept from being negative: where paint ends the spline would otherwise dip
/// below the support and draw a dark line around every stroke. With them the spline cannot.
void height_coefficients(const film::FilmState& film, const grid::Rect& cells, float* out, int stride);

/// Their two parts: of the dry surface, as if no wet paint lay on it, and of the wet paint.
void support_coefficients(const film::FilmState& film, const grid::Rect& cells, float* out, int stride);
void paint_coefficients(const film::FilmState& film, const grid::Rect& cells, float* out, int stride);

/// The lowest and the highest of the cell means.
struct HeightRange {
    float lowest_mm = 0.0F, highest_mm = 0.0F;
};
HeightRange surface_range(const film::FilmState& film);
HeightRange united(const HeightRange& a, const HeightRange& b);

/// The range of a canvas that changes, by its tiles.
class TileRanges {
  public:
    /// These tiles are others; all of them on a canvas of another shape.
    void update(const film::FilmState& film, const std::vector<int>& tiles);

    /// Of all tiles: surface_range().
    HeightRange all() const;

  private:
    std::vector<HeightRange> ranges_;
};

/// Two heights between which all of the interpolated surface lies: the least and the greatest of its
/// coefficients.
HeightRange surface_bounds(const film::FilmState& film);

}  // namespace pastoso::shade
