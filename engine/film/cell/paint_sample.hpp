// What lies at a place of the canvas, as a brush that dips there would find it.
#pragma once

#include "film/state.hpp"
#include "pigment/bands.hpp"

namespace pastoso::film {

enum class PaintLayer {
    Bare,  ///< nothing but the support
    Wet,   ///< the film
    Dry    ///< the uppermost stratum
};

struct PaintSample {
    PaintLayer layer = PaintLayer::Bare;
    pigment::Coefficients coefficients{};  ///< of the paint, its clear medium included, per mm
};

/// The paint within a radius of a place, the cell there at least. Wet: sum(K_k h) / sum(h) over the
/// cells of the disc, where their mean thickness is that of a film (kBindingFilm_mm) or nothing dry lies
/// below; of two wet strata the upper one alone, where it is such a film itself. Dry: the mean over the
/// cells that hold a stratum, of what each holds uppermost. Cells beyond the canvas count for nothing.
PaintSample sample_paint(const FilmState& state, double x_mm, double y_mm, double radius_mm);

}  // namespace pastoso::film
