#include "python/meshes.hpp"

#include "python/arrays.hpp"

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace pastoso::python {
namespace {

namespace py = pybind11;

constexpr py::ssize_t kFloat = sizeof(float);

/// Rows of three numbers that lie in someone's vector.
template <class T, class Row>
py::array_t<T> rows_of_three(std::vector<Row> rows) {
    static_assert(sizeof(Row) == 3 * sizeof(T));
    auto owner = std::make_unique<std::vector<Row>>(std::move(rows));
    const auto count = static_cast<py::ssize_t>(owner->size());
    const T* first = reinterpret_cast<const T*>(owner->data());
    return py::array_t<T>({count, py::ssize_t{3}}, first, keeper(std::move(owner)));
}

}  // namespace

py::array_t<float> array_of(grid::BoxField field, liquid::Location location) {
    auto owner = std::make_unique<grid::BoxField>(std::move(field));
    const grid::BoxShape& shape = owner->shape();
    const std::array<int, 3> counts = liquid::sample_counts(shape, location);
    const float* first = owner->row(0, 0);
    const Sizes sizes = {counts[2], counts[1], counts[0]};
    const Sizes strides = {shape.stride_z() * kFloat, shape.stride_y() * kFloat, kFloat};
    return py::array_t<float>(sizes, strides, first, keeper(std::move(owner)));
}

py::tuple arrays_of(liquid::VelocityField velocity) {
    return py::make_tuple(array_of(std::move(velocity.x), liquid::Location::FaceX),
                          array_of(std::move(velocity.y), liquid::Location::FaceY),
                          array_of(std::move(velocity.z), liquid::Location::FaceZ));
}

py::array_t<float> array_of(liquid::SampledField field) {
    auto owner = std::make_unique<liquid::SampledField>(std::move(field));
    const liquid::Lattice& lattice = owner->lattice();
    const float* first = owner->row(0, 0);
    const Sizes sizes = {lattice.nz, lattice.ny, lattice.nx};
    const Sizes strides = {owner->stride_z() * kFloat, owner->stride_y() * kFloat, kFloat};
    return py::array_t<float>(sizes, strides, first, keeper(std::move(owner)));
}

py::tuple arrays_of(liquid::TriangleMesh mesh) {
    const py::object normals =
        mesh.normals.empty() ? py::object(py::none()) : rows_of_three<float>(std::move(mesh.normals));
    return py::make_tuple(rows_of_three<float>(std::move(mesh.positions_m)), normals,
                          rows_of_three<std::uint32_t>(std::move(mesh.triangles)));
}

py::dtype record_type(std::initializer_list<RecordPart> parts, std::size_t bytes) {
    py::list names, formats, offsets;
    for (const RecordPart& part : parts) {
        names.append(part.name);
        formats.append(part.format);
        offsets.append(part.offset);
    }
    return py::dtype(names, formats, offsets, static_cast<py::ssize_t>(bytes));
}

}  // namespace pastoso::python
