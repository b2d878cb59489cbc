// The parts of the module, one for each subject.
#pragma once

#include <pybind11/pybind11.h>

namespace pastoso::python {

void add_film(pybind11::module_& module);
void add_painting(pybind11::module_& module);
void add_tea(pybind11::module_& module);
void add_tank(pybind11::module_& module);
/// The solver of paint held against exact laws.
void add_validation(pybind11::module_& module);
/// What there is to paint with, and scenes, by their names.
void add_catalogue(pybind11::module_& module);

}  // namespace pastoso::python
