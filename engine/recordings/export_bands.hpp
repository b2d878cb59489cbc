// Large exports go through the canvas in bands of rows, and can be stopped between two of them.
#pragma once

#include "files/keep_going.hpp"
#include "shade/render.hpp"

#include <functional>

namespace pastoso::recordings {

/// What is exported: a canvas, the internal reflectance of its bare support, how finely, in which light.
struct ExportSource {
    const film::FilmState& film;
    pigment::Bands ground{};
    shade::RenderSettings settings{};
    bool lit = true;  ///< otherwise pictures show the paint's colours without light and shade
};

/// The pixels of a whole canvas at the scale of the settings. Throws InputError as
/// shade::picture_lattice() does.
shade::Lattice export_lattice(const ExportSource& source);

/// The pixels of the file per millimetre of the canvas.
double export_px_per_mm(const ExportSource& source);

inline constexpr double kBandPixels = 1 << 21;

/// Calls work(pixels) for bands that together make up the lattice, from the top. A band has at most
/// `most_pixels` (or eight rows) and lies over some four million cells. False when `keep_going` said so.
bool for_each_band(const shade::Lattice& lattice, const files::KeepGoing& keep_going,
                   const std::function<void(const grid::Rect& pixels)>& work,
                   double most_pixels = kBandPixels);

}  // namespace pastoso::recordings
