#include "liquid/components.hpp"

#include <array>

namespace pastoso::liquid {
namespace {

struct Cell {
    int i, j, k;
};

/// Gives every cell that is connected with `seed` the number `component`, and tells whether none of them
/// has a boundary or mass.
bool flood(const CellMatrix& matrix, const Cell& seed, int component, std::vector<int>& of_cell) {
    const grid::BoxShape& shape = matrix.shape();
    bool closed = true;
    std::vector<Cell> waiting = {seed};
    const auto visit = [&](int i, int j, int k, float coefficient) {
        if (!(coefficient > 0.0F)) return;
        int& label = of_cell[static_cast<std::size_t>((k * shape.ny + j) * shape.nx + i)];
        if (label != 0) return;
        label = component;
        waiting.push_back({i, j, k});
    };
    visit(seed.i, seed.j, seed.k, 1.0F);
    while (!waiting.empty()) {
        const auto [i, j, k] = waiting.back();
        waiting.pop_back();
        closed = closed && matrix.boundary.at(i, j, k) + matrix.mass.at(i, j, k) <= 0.0F;
        const VelocityField& faces = matrix.faces;
        visit(i - 1, j, k, faces.x.at(i, j, k));
        visit(i + 1, j, k, faces.x.at(i + 1, j, k));
        visit(i, j - 1, k, faces.y.at(i, j, k));
        visit(i, j + 1, k, faces.y.at(i, j + 1, k));
        visit(i, j, k - 1, faces.z.at(i, j, k));
        visit(i, j, k + 1, faces.z.at(i, j, k + 1));
    }
    return closed;
}

}  // namespace

ClosedComponents closed_components(const CellMatrix& matrix) {
    const grid::BoxShape& shape = matrix.shape();
    ClosedComponents components;
    components.of_cell.resize(static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
                              static_cast<std::size_t>(shape.nz));
    std::vector<int> number_of = {0};
    std::size_t cell = 0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i, ++cell) {
                if (components.of_cell[cell] != 0 || !(matrix.diagonal(i, j, k) > 0.0F)) continue;
                const int component = static_cast<int>(number_of.size());
                const bool closed = flood(matrix, {i, j, k}, component, components.of_cell);
                number_of.push_back(closed ? ++components.count : 0);
            }
    components.sizes.resize(static_cast<std::size_t>(components.count) + 1);
    for (int& label : components.of_cell) {
        label = number_of[static_cast<std::size_t>(label)];
        ++components.sizes[static_cast<std::size_t>(label)];
    }
    return components;
}

}  // namespace pastoso::liquid
