// What the brush tests paint with: canvases, brushes with a linear response, strokes along curves, and
// measures of what they leave.
#pragma once

#include "brush/brush.hpp"
#include "brush/pen_sample.hpp"
#include "film/state.hpp"

#include <functional>

namespace pastoso::brush {
class Stroke;
}

namespace pastoso::brush::studio {

/// An empty linen canvas.
film::FilmState linen(double width_mm, double height_mm, double px_per_mm = 8.0);

/// An empty smooth one.
film::FilmState smooth(double width_mm, double height_mm, double px_per_mm = 8.0);

/// Covers the rectangle of cells (the whole canvas by default) with wet paint.
void cover(film::FilmState& film, double thickness_mm, const film::PaintCoefficients& paint);
void cover(film::FilmState& film, const grid::Rect& cells, double thickness_mm,
           const film::PaintCoefficients& paint);

/// Lays wet paint over all that lies there, which becomes the lower stratum.
void lay_over(film::FilmState& film, double thickness_mm, const film::PaintCoefficients& paint);

/// Made-up paints whose channels all differ: one that absorbs much, one that scatters much.
film::PaintCoefficients dark_paint();
film::PaintCoefficients light_paint();

/// A preset whose press is the pressure and lean the tangent of the tilt, at every speed: without the
/// curves.
Preset linear(const Preset& preset);
Preset flat_preset(double width_mm, int bristles = 300);
Preset round_preset(double width_mm);

/// Rises and falls smoothly over the first and last 6% of t in [0, 1].
double fade(double t);

/// t in [0, 1] to a sample; the time is set by paint().
using Movement = std::function<PenSample(double t)>;
Movement line(double x0_mm, double y0_mm, double x1_mm, double y1_mm, double pressure,
              double rotation_deg);

/// One stroke of `duration_s` sampled at `rate_Hz`.
void paint(Brush& brush, film::FilmState& film, const Movement& movement, double rate_Hz = 250.0,
           double duration_s = 1.0);

/// The same with a stroke that has not begun.
void paint(Stroke& stroke, const Movement& movement, double rate_Hz = 250.0, double duration_s = 1.0);

/// All paint on the canvas.
Contents contents(const film::FilmState& film);

/// Largest difference of volume and of all that the paint carries, relative.
double balance_error(const Contents& a, const Contents& b);

double volume_mm3(const film::FilmState& film);
double thickness_mm(const film::FilmState& film, int x, int y);
double mean_thickness_mm(const film::FilmState& film, const grid::Rect& cells);
double highest_mm(const film::FilmState& film, const grid::Rect& cells);

/// Share of the cells that hold more than 10 um.
double coverage(const film::FilmState& film, const grid::Rect& cells);

grid::Rect cells_of(const film::FilmState& film, double x0_mm, double y0_mm, double x1_mm, double y1_mm);

/// Mean absolute difference of the thickness in blocks of `block_mm`, against the mean of `a`. The cell
/// sizes may differ.
double relative_difference(const film::FilmState& a, const film::FilmState& b, double block_mm);

}  // namespace pastoso::brush::studio
