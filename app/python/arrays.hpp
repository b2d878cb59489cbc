// NumPy arrays of what the engine has computed, and of what it is given.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

namespace pastoso::python {

using Sizes = std::vector<pybind11::ssize_t>;

/// Any object as the owner of memory that arrays lie in.
template <class Owner>
pybind11::capsule keeper(std::unique_ptr<Owner> owner) {
    Owner* kept = owner.release();
    return pybind11::capsule(kept, [](void* memory) { delete static_cast<Owner*>(memory); });
}

/// The values as an array that lies in their own memory: nothing is copied. Strides in bytes; none: row
/// by row.
template <class T>
pybind11::array_t<T> array_of(std::vector<T> values, const Sizes& shape) {
    auto owner = std::make_unique<std::vector<T>>(std::move(values));
    const T* first = owner->data();
    return pybind11::array_t<T>(shape, first, keeper(std::move(owner)));
}

/// `given`, or where it is None a new array of floats. Throws InputError unless what is given is of that
/// shape and float32, row by row, and may be written to.
pybind11::array output_array(const pybind11::object& given, const Sizes& shape);

/// The floats of an array of that shape, which is float32, row by row. Throws InputError that calls it
/// `name` otherwise.
std::span<const float> floats_of(const pybind11::array& array, const Sizes& shape,
                                 const std::string& name);

/// "(48, 64)".
std::string shape_text(const Sizes& shape);

}  // namespace pastoso::python
