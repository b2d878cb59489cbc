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
              ? GroupRange{begin, begin + kGroup, begin, begin}
              : GroupRange{std::min(row.begin, begin), std::max(row.end, begin + kGroup), begin, begin};
    ++level.cell_count;
}

/// Whether a cell has six neighbours and passes the same to all of them.
bool is_even(const CellMatrix& matrix, float coefficient, int i, int j, int k) {
    const grid::BoxShape& shape = matrix.shape();
    const VelocityField& faces = matrix.faces;
    return i + 1 < shape.nx && j + 1 < shape.ny && k + 1 < shape.nz &&
           faces.x.at(i, j, k) == coefficient && faces.x.at(i + 1, j, k) == coefficient &&
           faces.y.at(i, j, k) == coefficient && faces.y.at(i, j + 1, k) == coefficient &&
           faces.z.at(i, j, k) == coefficient && faces.z.at(i, j, k + 1) == coefficient;
}

/// That of the first even cell with the largest coefficient there is; of none: all 0.
PlainEquation plain_equation(const CellMatrix& matrix) {
    const grid::BoxShape& shape = matrix.shape();
    const float coefficient = *std::ranges::max_element(matrix.faces.x.values());
    if (!(coefficient > 0.0F)) return {};
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                if (is_even(matrix, coefficient, i, j, k)) {
                    const float diagonal = matrix.diagonal(i, j, k);
                    return {coefficient, diagonal, 1.0F / diagonal};
                }
    return {};
}

/// The first run of plain groups of each row.
void find_plain_groups(const CellMatrix& matrix, MultigridLevel& level) {
    level.plain = plain_equation(matrix);
    if (!(level.plain.diagonal > kLeastDiagonal)) return;
    const auto is_plain = [&](int group, int j, int k) {
        if (2 * (group + kGroup) > level.extent.nx) return false;
        for (int i = 2 * group; i < 2 * (group + kGroup); ++i)
            if (!is_even(matrix, level.plain.coefficient, i, j, k) ||
                matrix.diagonal(i, j, k) != level.plain.diagonal)
                return false;
        return true;
    };
    for (int k = 0; k < level.extent.nz; ++k)
        for (int j = 0; j < level.extent.ny; ++j) {
            GroupRange& row = level.rows[static_cast<std::size_t>(k * level.extent.ny + j)];
            row.plain_begin = row.begin;
            while (row.plain_begin < row.end && !is_plain(row.plain_begin, j, k))
                row.plain_begin += kGroup;
            row.plain_end = row.plain_begin;
            while (row.plain_end < row.end && is_plain(row.plain_end, j, k))
                row.plain_end += kGroup;
        }
}

MultigridLevel level_of(const CellMatrix& matrix) {
    const grid::BoxShape& shape = matrix.shape();
    MultigridLevel level;
    level.extent = {shape.nx, shape.ny, shape.nz};
    for (ColourField* field : {&level.west, &level.south, &level.below, &level.diagonal, &level.inverse,
                               &level.value, &level.source})
        *field = ColourField(level.extent);
    level.rows.assign(static_cast<std::size_t>(shape.ny * shape.nz), {0, 0, 0, 0});
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
    find_plain_groups(matrix, level);
    return level;
}

}  // namespace

LevelView MultigridLevel::view() {
    return {extent,       extent.stride_y(), extent.stride_z(), west.data(),
            south.data(), below.data(),      diagonal.data(),   inverse.data(),
            value.data(), source.data(),     rows.data(),       plain};
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
