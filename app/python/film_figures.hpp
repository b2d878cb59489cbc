// What is measured of a film, for Python.
#pragma once

#include "python/film_work.hpp"

#include <string>

#include <pybind11/numpy.h>

namespace pastoso::python {

/// Sums and extremes (film::Measures), and what ran off.
pybind11::dict measures_of(FilmWork& work);

/// The front of paint that runs (film::Front), or None.
pybind11::object front_of(FilmWork& work);

/// Cells of a line along "x" or "y": place, support and thickness in mm, velocities in mm/s. Throws
/// InputError for a line that is not on the canvas.
pybind11::array_t<double> profile_of(FilmWork& work, const std::string& along, double at_mm);

/// What stepping has taken.
pybind11::dict report_of(FilmWork& work);

}  // namespace pastoso::python
