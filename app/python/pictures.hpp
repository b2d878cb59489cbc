// Pictures of films as arrays.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "pigment/bands.hpp"
#include "shade/render.hpp"

#include <array>
#include <optional>
#include <string>

#include <pybind11/numpy.h>

namespace pastoso::python {

/// How a picture is asked for.
struct PictureWish {
    double scale = 1.0;                       ///< pixels per cell
    std::optional<std::array<int, 4>> cells;  ///< left, top, right, bottom; none: all
    bool lit = true;                          ///< otherwise the paint's colours without light and shade
    bool linear = false;                      ///< float32 of linear light; otherwise uint8 of sRGB
    std::string light = "D65";
    shade::Lighting lighting;
};

/// Takes apart the keyword arguments of a `render()`; those that are left out are as in a new wish.
/// Throws InputError for one that there is not, and for values out of their ranges.
PictureWish picture_wish(const pybind11::kwargs& wanted);

/// Whether pictures with values of this type, of whatever NumPy knows, are of linear light: those of
/// float32 are, those of uint8 are not. Throws InputError for all others.
bool is_linear(const pybind11::object& dtype);

/// What can be asked for, for documentation.
extern const char* const kPictureArguments;

/// A rendered picture, before Python has it.
struct RenderedPicture {
    pigment::LinearImage linear;  ///< without values where `encoded` holds them
    pigment::Image8 encoded;
};

/// Without Python's lock. Throws InputError for cells that are not on the canvas and scales that there
/// are not.
RenderedPicture rendered(const film::FilmState& film, const pigment::Bands& ground,
                         const PictureWish& wish, core::ThreadPool& pool);

/// (height, width, 3), in the picture's own memory.
pybind11::array array_of(RenderedPicture picture);

}  // namespace pastoso::python
