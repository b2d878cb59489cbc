#include "python/arrays.hpp"

#include "core/error.hpp"

namespace pastoso::python {
namespace {

namespace py = pybind11;

Sizes shape_of(const py::array& array) {
    return {array.shape(), array.shape() + array.ndim()};
}

bool is_row_by_row(const py::array& array) {
    return (array.flags() & py::array::c_style) != 0;
}

void check(const py::array& array, const Sizes& shape, const std::string& name) {
    const bool fits = py::isinstance<py::array_t<float>>(array) && is_row_by_row(array);
    if (fits && shape_of(array) == shape) return;
    throw core::InputError("the array \"%1\" is %2 %3%4, but must be float32 %5, row by row.", name,
                           std::string(py::str(array.dtype())), shape_text(shape_of(array)),
                           is_row_by_row(array) ? "" : ", not row by row", shape_text(shape));
}

}  // namespace

std::string shape_text(const Sizes& shape) {
    std::string text;
    for (const py::ssize_t size : shape)
        text += (text.empty() ? "" : ", ") + std::to_string(size);
    return "(" + text + ")";
}

py::array output_array(const py::object& given, const Sizes& shape) {
    if (given.is_none()) return py::array_t<float>(shape);
    if (!py::isinstance<py::array>(given))
        throw core::InputError("what \"out\" names is not a NumPy array.");
    py::array array = py::reinterpret_borrow<py::array>(given);
    check(array, shape, "out");
    if (!array.writeable()) throw core::InputError("the array \"out\" may not be written to.");
    return array;
}

std::span<const float> floats_of(const py::array& array, const Sizes& shape, const std::string& name) {
    check(array, shape, name);
    return {static_cast<const float*>(array.data()), static_cast<std::size_t>(array.size())};
}

}  // namespace pastoso::python
