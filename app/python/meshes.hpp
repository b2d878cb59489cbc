// Fields and surfaces of liquids as arrays, each in memory of its own that the engine has filled.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/flow/velocity.hpp"
#include "liquid/surface/sampled_field.hpp"
#include "liquid/surface/triangle_mesh.hpp"

#include <pybind11/numpy.h>

namespace pastoso::python {

/// (z, y, x) of a box's cells, or of its faces across an axis; what lies around the box is left out by
/// the strides.
pybind11::array_t<float> array_of(grid::BoxField field,
                                  liquid::Location location = liquid::Location::Cell);

/// The three of a velocity, across x, y and z.
pybind11::tuple arrays_of(liquid::VelocityField velocity);

/// (z, y, x) of a lattice's points.
pybind11::array_t<float> array_of(liquid::SampledField field);

/// Positions (count, 3) float32 in m, normals (count, 3) or none, triangles (count, 3) uint32.
pybind11::tuple arrays_of(liquid::TriangleMesh mesh);

/// A field of records: its name in Python, NumPy's format of it, and where it lies in a record.
struct RecordPart {
    const char* name;
    const char* format;
    std::size_t offset;
};

/// NumPy's type of records of that size.
pybind11::dtype record_type(std::initializer_list<RecordPart> parts, std::size_t bytes);

}  // namespace pastoso::python
