#include "liquid/pressure/multigrid_level.hpp"

#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::liquid {
namespace {

constexpr int kCoarsestSide_cells = 4;
/// Levels with fewer slices are filled by one thread: waking others would cost more.
constexpr int kLeastSlicesForThreads = 24;
/// Below this a cell counts as having no equation.
constexpr float kLeastDiagonal = 1e-9F;

/// The part of a coarse row that holds the cells of up to four fine rows.
RowRanges coarsened(const RowRanges& fine, const grid::BoxShape& from, const grid::BoxShape& to) {
    RowRanges coarse(to);
    for (int k = 0; k < from.nz; ++k)
        for (int j = 0; j < from.ny; ++j) {
            const RowRange row = fine.at(j, k);
            if (row.empty()) continue;
            coarse.include(row.begin / 2, j / 2, k / 2);
            coarse.include((row.end - 1) / 2, j / 2, k / 2);
        }
    return coarse;
}

void clear_rows(const RowRanges& rows, int k, CellMatrix& matrix) {
    for (int j = 0; j < matrix.shape().ny; ++j) {
        const RowRange row = rows.at(j, k);
        if (row.empty()) continue;
        for (grid::BoxField* field :
             {&matrix.faces.x, &matrix.faces.y, &matrix.faces.z, &matrix.boundary, &matrix.mass})
            std::fill(field->row(j, k) + row.begin, field->row(j, k) + row.end, 0.0F);
    }
}

/// Adds a row of fine cells to the next coarser matrix.
void coarsen_row(const CellMatrix& fine, RowRange row, int j, int k, CellMatrix& coarse) {
    const float *x = fine.faces.x.row(j, k), *y = fine.faces.y.row(j, k), *z = fine.faces.z.row(j, k),
                *boundary = fine.boundary.row(j, k), *mass = fine.mass.row(j, k);
    float *cx = coarse.faces.x.row(j / 2, k / 2), *cy = coarse.faces.y.row(j / 2, k / 2),
          *cz = coarse.faces.z.row(j / 2, k / 2), *coarse_boundary = coarse.boundary.row(j / 2, k / 2),
          *coarse_mass = coarse.mass.row(j / 2, k / 2);
    for (int i = row.begin; i < row.end; ++i) {
        if (i % 2 == 0) cx[i / 2] += 0.5F * x[i];
        if (j % 2 == 0) cy[i / 2] += 0.5F * y[i];
        if (k % 2 == 0) cz[i / 2] += 0.5F * z[i];
        coarse_boundary[i / 2] += 0.5F * boundary[i];
        coarse_mass[i / 2] += mass[i];
    }
}

GroupRange groups_of(RowRange row) {
    if (row.empty()) return {0, 0, 0, 0};
    const int begin = row.begin / 2 / kGroup * kGroup;
    const int end = ((row.end - 1) / 2 / kGroup + 1) * kGroup;
    return {begin, end, begin, begin};
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

/// That of the first even cell of a slice with that coefficient; of none: all 0.
PlainEquation plain_equation(const CellMatrix& matrix, const RowRanges& rows, float coefficient) {
    if (!(coefficient > 0.0F)) return {};
    for (int k = 0; k < matrix.shape().nz; ++k)
        for (int j = 0; j < matrix.shape().ny; ++j) {
            const RowRange row = rows.at(j, k);
            for (int i = row.begin; i < row.end; ++i)
                if (is_even(matrix, coefficient, i, j, k)) {
                    const float diagonal = matrix.diagonal(i, j, k);
                    return {coefficient, diagonal, 1.0F / diagonal};
                }
        }
    return {};
}

float largest_coefficient(const CellMatrix& matrix, const RowRanges& rows) {
    float largest = 0.0F;
    for (int k = 0; k < matrix.shape().nz; ++k)
        for (int j = 0; j < matrix.shape().ny; ++j) {
            const RowRange row = rows.at(j, k);
            const float* x = matrix.faces.x.row(j, k);
            for (int i = row.begin; i < row.end; ++i)
                largest = std::max(largest, x[i]);
        }
    return largest;
}

/// The first run of plain groups of a row.
void compute_plain_groups(const CellMatrix& matrix, int j, int k, MultigridLevel& level) {
    if (!(level.plain.diagonal > kLeastDiagonal)) return;
    const auto is_plain = [&](int group) {
        if (2 * (group + kGroup) > level.extent.nx) return false;
        for (int i = 2 * group; i < 2 * (group + kGroup); ++i)
            if (!is_even(matrix, level.plain.coefficient, i, j, k) ||
                matrix.diagonal(i, j, k) != level.plain.diagonal)
                return false;
        return true;
    };
    GroupRange& row = level.rows[static_cast<std::size_t>(k * level.extent.ny + j)];
    row.plain_begin = row.begin;
    while (row.plain_begin < row.end && !is_plain(row.plain_begin))
        row.plain_begin += kGroup;
    row.plain_end = row.plain_begin;
    while (row.plain_end < row.end && is_plain(row.plain_end))
        row.plain_end += kGroup;
}

/// Both colours of a row without equations.
void clear_row(int j, int k, MultigridLevel& level) {
    const std::size_t row = static_cast<std::size_t>(k * level.extent.ny + j);
    const GroupRange& used = level.rows[row];
    for (ColourField* field : {&level.west, &level.south, &level.below, &level.diagonal, &level.inverse,
                               &level.value, &level.source})
        for (float* colour : field->data().colour) {
            float* first = colour + j * level.extent.stride_y() + k * level.extent.stride_z();
            std::fill(first + used.begin, first + used.end, 0.0F);
        }
    level.rows[row] = {0, 0, 0, 0};
}

/// Takes the equations of a row; returns how many there are.
long fill_row(const CellMatrix& matrix, RowRange row, int j, int k, MultigridLevel& level) {
    long count = 0;
    RowRange used;
    for (int i = row.begin; i < row.end; ++i) {
        const float diagonal = matrix.diagonal(i, j, k);
        if (!(diagonal > kLeastDiagonal)) continue;
        level.west.at(i, j, k) = matrix.faces.x.at(i, j, k);
        level.south.at(i, j, k) = matrix.faces.y.at(i, j, k);
        level.below.at(i, j, k) = matrix.faces.z.at(i, j, k);
        level.diagonal.at(i, j, k) = diagonal;
        level.inverse.at(i, j, k) = 1.0F / diagonal;
        used = used.empty() ? RowRange{i, i + 1} : RowRange{used.begin, i + 1};
        ++count;
    }
    level.rows[static_cast<std::size_t>(k * level.extent.ny + j)] = groups_of(used);
    compute_plain_groups(matrix, j, k, level);
    return count;
}

void fill_level(const CellMatrix& matrix, const RowRanges& rows, MultigridLevel& level,
                core::ThreadPool& pool) {
    level.plain = plain_equation(matrix, rows, largest_coefficient(matrix, rows));
    level.cell_count = sum_over_slices(pool, level.extent.nz, [&](int k) {
        long count = 0;
        for (int j = 0; j < level.extent.ny; ++j) {
            clear_row(j, k, level);
            if (!rows.at(j, k).empty()) count += fill_row(matrix, rows.at(j, k), j, k, level);
        }
        return count;
    });
}

grid::BoxShape half(const grid::BoxShape& shape) {
    return {(shape.nx + 1) / 2, (shape.ny + 1) / 2, (shape.nz + 1) / 2, 2.0F * shape.cell_m};
}

}  // namespace

MultigridLevel::MultigridLevel(const LevelExtent& level_extent)
    : extent(level_extent),
      west(extent),
      south(extent),
      below(extent),
      diagonal(extent),
      inverse(extent),
      value(extent),
      source(extent),
      rows(static_cast<std::size_t>(extent.ny * extent.nz), {0, 0, 0, 0}) {}

LevelView MultigridLevel::view() {
    return {extent,       extent.stride_y(), extent.stride_z(), west.data(),
            south.data(), below.data(),      diagonal.data(),   inverse.data(),
            value.data(), source.data(),     rows.data(),       plain};
}

MultigridLevels::MultigridLevels(const grid::BoxShape& shape) {
    levels_.push_back(MultigridLevel({shape.nx, shape.ny, shape.nz}));
    for (grid::BoxShape coarse = shape;
         std::max({coarse.nx, coarse.ny, coarse.nz}) > kCoarsestSide_cells;) {
        coarse = half(coarse);
        levels_.push_back(MultigridLevel({coarse.nx, coarse.ny, coarse.nz}));
        coarse_.emplace_back(coarse);
        rows_.emplace_back(coarse);
    }
}

void MultigridLevels::set_matrix(const CellMatrix& matrix, const RowRanges& rows,
                                 core::ThreadPool& pool) {
    fill_level(matrix, rows, levels_.front(), pool);
    compute_closed_components(matrix, rows, levels_.front().closed);
    const CellMatrix* fine = &matrix;
    const RowRanges* fine_rows = &rows;
    core::ThreadPool this_thread(1);
    for (std::size_t n = 0; n < coarse_.size(); ++n) {
        CellMatrix& coarse = coarse_[n];
        RowRanges coarse_rows = coarsened(*fine_rows, fine->shape(), coarse.shape());
        core::ThreadPool& some = coarse.shape().nz >= kLeastSlicesForThreads ? pool : this_thread;
        for_slices(some, 0, coarse.shape().nz, [&](int coarse_k) {
            clear_rows(rows_[n], coarse_k, coarse);
            for (int k = 2 * coarse_k; k < std::min(2 * coarse_k + 2, fine->shape().nz); ++k)
                for (int j = 0; j < fine->shape().ny; ++j)
                    if (!fine_rows->at(j, k).empty())
                        coarsen_row(*fine, fine_rows->at(j, k), j, k, coarse);
        });
        rows_[n] = std::move(coarse_rows);
        fill_level(coarse, rows_[n], levels_[n + 1], some);
        fine = &coarse;
        fine_rows = &rows_[n];
    }
    if (!coarse_.empty()) compute_closed_components(coarse_.back(), rows_.back(), levels_.back().closed);
}

}  // namespace pastoso::liquid
