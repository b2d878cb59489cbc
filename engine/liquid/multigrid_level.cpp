#include "liquid/multigrid_level.hpp"

#include <algorithm>

namespace pastoso::liquid {
namespace {

constexpr int kCoarsestSide_cells = 4;
/// Below this a cell counts as having no equation.
constexpr float kLeastDiagonal = 1e-9F;

/// The matrix of the next coarser level, made before any of it is put into checkerboard order.
CellMatrix coarsened(const CellMatrix& fine) {
    const grid::BoxShape& from = fine.shape();
    const auto half = [](int cells) { return (cells + 1) / 2; };
    CellMatrix coarse({half(from.nx), half(from.ny), half(from.nz), 2.0F * from.cell_m});
    for (int k = 0; k < from.nz; ++k)
        for (int j = 0; j < from.ny; ++j)
            for (int i = 0; i < from.nx; ++i) {
                const int ci = i / 2, cj = j / 2, ck = k / 2;
                if (i % 2 == 0) coarse.faces.x.at(ci, cj, ck) += 0.5F * fine.faces.x.at(i, j, k);
                if (j % 2 == 0) coarse.faces.y.at(ci, cj, ck) += 0.5F * fine.faces.y.at(i, j, k);
                if (k % 2 == 0) coarse.faces.z.at(ci, cj, ck) += 0.5F * fine.faces.z.at(i, j, k);
                coarse.boundary.at(ci, cj, ck) += 0.5F * fine.boundary.at(i, j, k);
                coarse.mass.at(ci, cj, ck) += fine.mass.at(i, j, k);
            }
    return coarse;
}

void include_cell(MultigridLevel& level, int i, int j, int k) {
    GroupRange& row = level.rows[static_cast<std::size_t>(k * level.extent.ny + j)];
    const int begin = i / 2 / kGroup * kGroup;
    row = row.begin == row.end
              ? GroupRange{begin, begin + kGroup}
              : GroupRange{std::min(row.begin, begin), std::max(row.end, begin + kGroup)};
    ++level.cell_count;
}

MultigridLevel level_of(const CellMatrix& matrix) {
    const grid::BoxShape& shape = matrix.shape();
    MultigridLevel level;
    level.extent = {shape.nx, shape.ny, shape.nz};
    for (ColourField* field : {&level.west, &level.south, &level.below, &level.diagonal, &level.inverse,
                               &level.value, &level.source})
        *field = ColourField(level.extent);
    level.rows.assign(static_cast<std::size_t>(shape.ny * shape.nz), {0, 0});
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const float diagonal = matrix.diagonal(i, j, k);
                if (!(diagonal > kLeastDiagonal)) continue;
                level.west.at(i, j, k) = matrix.faces.x.at(i, j, k);
                level.south.at(i, j, k) = matrix.faces.y.at(i, j, k);
                level.below.at(i, j, k) = matrix.faces.z.at(i, j, k);
                level.diagonal.at(i, j, k) = diagonal;
                level.inverse.at(i, j, k) = 1.0F / diagonal;
                include_cell(level, i, j, k);
            }
    return level;
}

}  // namespace

LevelView MultigridLevel::view() {
    return {extent,       extent.stride_y(), extent.stride_z(), west.data(),
            south.data(), below.data(),      diagonal.data(),   inverse.data(),
            value.data(), source.data(),     rows.data()};
}

std::vector<MultigridLevel> multigrid_levels(const CellMatrix& matrix) {
    std::vector<MultigridLevel> levels;
    levels.push_back(level_of(matrix));
    levels.front().closed = closed_components(matrix);
    CellMatrix coarse = matrix;
    while (std::max({coarse.shape().nx, coarse.shape().ny, coarse.shape().nz}) > kCoarsestSide_cells) {
        coarse = coarsened(coarse);
        levels.push_back(level_of(coarse));
    }
    levels.back().closed = closed_components(coarse);
    return levels;
}

}  // namespace pastoso::liquid
