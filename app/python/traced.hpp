// Path-traced pictures of liquids as arrays.
#pragma once

#include "core/thread_pool.hpp"
#include "python/pictures.hpp"
#include "python/turn.hpp"
#include "trace/scene.hpp"

#include <functional>

#include <pybind11/numpy.h>

namespace pastoso::python {

/// How a picture of a liquid is asked for.
struct TracedWish {
    int width = 0, height = 0;  ///< pixels
    int samples = 0;            ///< a pixel
    bool denoised = true;
    bool linear = false;  ///< the radiance, float32; otherwise uint8 of sRGB, as a screen shall show it
};

/// Throws InputError for values out of their ranges. `dtype`: whatever NumPy knows as uint8 or float32.
TracedWish traced_wish(int width, int height, int samples, bool denoised, const pybind11::object& dtype);

/// Follows light through the scene, without Python's lock; an empty picture where it was interrupted.
RenderedPicture traced(const trace::Scene& scene, const TracedWish& wish, core::ThreadPool& pool,
                       Interruption& interruption);

}  // namespace pastoso::python
