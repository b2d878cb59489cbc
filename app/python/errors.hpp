// How the engine's failures reach Python.
#pragma once

#include <pybind11/pybind11.h>

namespace pastoso::python {

/// Adds InputError(ValueError) and InternalError(RuntimeError), and translates into them: bad input,
/// with its own sentence; broken invariants, which do not abort any more. What the system refuses
/// becomes OSError and MemoryError.
void add_errors(pybind11::module_& module);

}  // namespace pastoso::python
