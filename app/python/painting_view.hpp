// What Python sees of a painting.
#pragma once

#include "document/undo_step.hpp"
#include "python/painting_work.hpp"

#include <string>
#include <vector>

#include <pybind11/numpy.h>

namespace pastoso::python {

/// A field of what is visible, or of the mixing well (film_fields.hpp), in `out` where that is not None.
pybind11::array read_painting(PaintingWork& work, const std::string& name, const pybind11::object& out,
                              bool well);

/// A picture (pictures.hpp); "well" may be among what is wanted.
pybind11::array render_painting(PaintingWork& work, const pybind11::kwargs& wanted);

pybind11::list layers_of(PaintingWork& work);
pybind11::dict account_of(PaintingWork& work);
pybind11::list step_names(const std::vector<document::KeptStep>& kept);

}  // namespace pastoso::python
