#include "liquid/surface/sampled_field.hpp"

#include "core/check.hpp"

namespace pastoso::liquid {
namespace {

constexpr int kRowPadding = 8, kLine = 16;

std::ptrdiff_t row_stride(int nx) {
    return (nx + kRowPadding + kLine - 1) / kLine * kLine;
}

}  // namespace

Lattice cell_centres(const grid::BoxShape& shape, int parts) {
    PASTOSO_CHECK_OP(parts, >=, 1);
    const float spacing_m = shape.cell_m / static_cast<float>(parts);
    return {shape.nx * parts, shape.ny * parts, shape.nz * parts, spacing_m,
            glm::vec3(0.5F * spacing_m)};
}

SampledField::SampledField(const Lattice& lattice, float value) {
    assign(lattice, value);
}

void SampledField::assign(const Lattice& lattice, float value) {
    PASTOSO_CHECK(lattice.nx >= 1 && lattice.ny >= 1 && lattice.nz >= 1);
    PASTOSO_CHECK_OP(lattice.spacing_m, >, 0.0F);
    lattice_ = lattice;
    stride_y_ = row_stride(lattice.nx);
    values_.assign(static_cast<std::size_t>(stride_z()) * static_cast<std::size_t>(lattice.nz), value);
}

}  // namespace pastoso::liquid
