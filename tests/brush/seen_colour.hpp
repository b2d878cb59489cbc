// What wet paint looks like, cell by cell, for tests of what lies on top.
#pragma once

#include "film/dry_film.hpp"
#include "film/medium.hpp"
#include "film/state.hpp"
#include "pigment/colour.hpp"
#include "pigment/lab.hpp"
#include "pigment/palette.hpp"

namespace pastoso::brush::studio {

inline film::PaintCoefficients paint_in(const char* pigment, const char* medium) {
    return film::paint_coefficients(pigment::find_pigment(pigment).coefficients,
                                    film::find_medium(medium));
}

inline film::PaintCoefficients oil(const char* pigment) {
    return paint_in(pigment, "heavy-body oil");
}

/// What is seen of a ground, linear sRGB.
inline pigment::LinearRgb seen_rgb(pigment::Bands ground) {
    for (float& band : ground)
        band = pigment::through_surface(band);
    return pigment::linear_srgb(ground);
}

/// What is seen of both wet strata of a cell over a ground, linear sRGB.
inline pigment::LinearRgb seen_rgb(const film::FilmState& film, int x, int y,
                                   const pigment::Bands& ground = film::test::kWhiteGround) {
    const film::PaintCell lower = film.lower.paint.at(x, y);
    const film::PaintCell upper = film::upper_paint(lower, film.paint.at(x, y));
    return seen_rgb(film::test::wet_over(upper.data(), film::test::wet_over(lower.data(), ground)));
}

/// The mean colour of what is seen of some cells.
inline pigment::Lab seen_colour(const film::FilmState& film, const grid::Rect& cells,
                                const pigment::Bands& ground = film::test::kWhiteGround) {
    pigment::LinearRgb sum{};
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x) {
            const pigment::LinearRgb rgb = seen_rgb(film, x, y, ground);
            for (std::size_t k = 0; k < sum.size(); ++k)
                sum[k] += rgb[k] / (cells.width() * cells.height());
        }
    return pigment::lab(sum);
}

}  // namespace pastoso::brush::studio
