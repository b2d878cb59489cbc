// A velocity on the faces of a box's cells (marker-and-cell grid): x(i, j, k) is the velocity across the
// face at (i, j + 0.5, k + 0.5) in cell units, and so on for y and z.
#pragma once

#include "grid/box_field.hpp"
#include "liquid/flow/field_view.hpp"

#include <array>

#include <glm/vec3.hpp>

namespace pastoso::liquid {

inline constexpr std::array<int, 3> kAxes = {0, 1, 2};

struct VelocityField {
    grid::BoxField x, y, z;  ///< in m/s

    VelocityField() = default;
    explicit VelocityField(const grid::BoxShape& shape) : x(shape), y(shape), z(shape) {}

    const grid::BoxShape& shape() const { return x.shape(); }
    grid::BoxField& along(int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    const grid::BoxField& along(int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    friend bool operator==(const VelocityField&, const VelocityField&) = default;
};

/// The faces of a row from cell i on.
inline FaceRows face_rows(const VelocityField& field, int i, int j, int k) {
    return {field.x.row(j, k) + i, field.y.row(j, k) + i, field.z.row(j, k) + i,
            field.shape().stride_y(), field.shape().stride_z()};
}

/// Where the samples of a field lie within their cell, in cell units.
enum class Location { FaceX, FaceY, FaceZ, Cell };

inline Location face_across(int axis) {
    return static_cast<Location>(axis);
}
inline glm::vec3 offset_cells(Location location) {
    glm::vec3 offset(0.5F);
    if (location != Location::Cell) offset[static_cast<int>(location)] = 0.0F;
    return offset;
}
/// How many samples there are along each axis of the box: one more across a face.
inline std::array<int, 3> sample_counts(const grid::BoxShape& shape, Location location) {
    std::array<int, 3> counts = {shape.nx, shape.ny, shape.nz};
    if (location != Location::Cell) ++counts[static_cast<std::size_t>(location)];
    return counts;
}

/// What lies between a sample and the next one along an axis.
inline std::ptrdiff_t stride(const grid::BoxShape& shape, int axis) {
    return axis == 0 ? 1 : axis == 1 ? shape.stride_y() : shape.stride_z();
}

}  // namespace pastoso::liquid
