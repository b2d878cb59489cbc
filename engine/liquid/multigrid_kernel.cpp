// Half sweeps of a multigrid level and the vector operations of conjugate gradients, slice by slice.
// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/kernels.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

constexpr int kFirstColour = 0, kLastColour = 1;
constexpr int kMaxHalf = 512 / 2 + 2 * kGroup;

/// One colour of a row: its cells of the range, and where the cells around them stand in the other
/// colour.
struct Row {
    std::ptrdiff_t at;  ///< m = 0
    int west;           ///< from m to the cell to the west; the one to the east stands one further
    int begin, end;
};
[[gnu::always_inline]] inline Row row_of(const LevelView& level, int colour, int j, int k) {
    const GroupRange range = level.rows[k * level.extent.ny + j];
    return {j * level.stride_y + k * level.stride_z, ((j + k + colour) & 1) - 1, range.begin, range.end};
}

/// The pointers that a row's equations need.
struct Equations {
    const float *west, *east, *south, *north, *below, *above;              ///< coefficients
    const float *x_west, *x_east, *x_south, *x_north, *x_below, *x_above;  ///< the neighbours' values

    [[gnu::always_inline]] Equations(const LevelView& level, const Row& row, int colour,
                                     const ColourPointers& values) {
        const int other = 1 - colour;
        const std::ptrdiff_t at = row.at, y = level.stride_y, z = level.stride_z;
        west = level.west.colour[colour] + at;
        east = level.west.colour[other] + at + row.west + 1;
        south = level.south.colour[colour] + at;
        north = level.south.colour[other] + at + y;
        below = level.below.colour[colour] + at;
        above = level.below.colour[other] + at + z;
        const float* x = values.colour[other] + at;
        x_west = x + row.west;
        x_east = x + row.west + 1;
        x_south = x - y;
        x_north = x + y;
        x_below = x - z;
        x_above = x + z;
    }
    /// What the neighbours add to cell m: the sum of a_f x_f.
    [[gnu::always_inline]] float inflow(int m) const {
        return ((west[m] * x_west[m] + east[m] * x_east[m]) +
                (south[m] * x_south[m] + north[m] * x_north[m])) +
               (below[m] * x_below[m] + above[m] * x_above[m]);
    }
};

/// A sum in kGroup lanes, each in its own order whatever the registers' width.
struct LaneSum {
    float lane[kGroup] = {};
    [[gnu::always_inline]] double total() const {
        return (static_cast<double>((lane[0] + lane[4]) + (lane[2] + lane[6])) +
                static_cast<double>((lane[1] + lane[5]) + (lane[3] + lane[7])));
    }
};

[[gnu::always_inline]] inline double product(const float* a, const float* b, int begin, int end) {
    LaneSum sum;
    for (int group = begin; group < end; group += kGroup)
        for (int lane = 0; lane < kGroup; ++lane)
            sum.lane[lane] += a[group + lane] * b[group + lane];
    return sum.total();
}

[[gnu::always_inline]] inline double total(const float* a, int begin, int end) {
    LaneSum sum;
    for (int group = begin; group < end; group += kGroup)
        for (int lane = 0; lane < kGroup; ++lane)
            sum.lane[lane] += a[group + lane];
    return sum.total();
}

[[gnu::always_inline]] inline void relax_row(const LevelView& level, const Row& row, int colour) {
    const Equations cell(level, row, colour, level.value);
    float* __restrict x = level.value.colour[colour] + row.at;
    const float* b = level.source.colour[colour] + row.at;
    const float* inverse = level.inverse.colour[colour] + row.at;
    for (int m = row.begin; m < row.end; ++m)
        x[m] = (b[m] + cell.inflow(m)) * inverse[m];
}

}  // namespace

void relax_from_zero(const LevelView& level, int k) {
    for (int j = 0; j < level.extent.ny; ++j) {
        const Row row = row_of(level, kFirstColour, j, k);
        float* __restrict x = level.value.colour[kFirstColour] + row.at;
        const float* b = level.source.colour[kFirstColour] + row.at;
        const float* inverse = level.inverse.colour[kFirstColour] + row.at;
        for (int m = row.begin; m < row.end; ++m)
            x[m] = b[m] * inverse[m];
    }
}

void relax(const LevelView& level, int colour, int k) {
    for (int j = 0; j < level.extent.ny; ++j)
        relax_row(level, row_of(level, colour, j, k), colour);
}

double relax_and_multiply(const LevelView& level, int k) {
    double sum = 0.0;
    for (int j = 0; j < level.extent.ny; ++j) {
        const Row row = row_of(level, kFirstColour, j, k);
        relax_row(level, row, kFirstColour);
        for (int colour = kFirstColour; colour <= kLastColour; ++colour)
            sum += product(level.value.colour[colour] + row.at, level.source.colour[colour] + row.at,
                           row.begin, row.end);
    }
    return sum;
}

void restrict_residual(const LevelView& fine, const LevelView& coarse, int coarse_k) {
    float sum[2 * kMaxHalf];
    for (int coarse_j = 0; coarse_j < coarse.extent.ny; ++coarse_j) {
        const GroupRange range = coarse.rows[coarse_k * coarse.extent.ny + coarse_j];
        if (range.begin == range.end) continue;
        for (int m = 2 * range.begin; m < 2 * range.end; ++m)
            sum[m] = 0.0F;
        for (int k = 2 * coarse_k; k < 2 * coarse_k + 2 && k < fine.extent.nz; ++k)
            for (int j = 2 * coarse_j; j < 2 * coarse_j + 2 && j < fine.extent.ny; ++j) {
                const Row row = row_of(fine, kFirstColour, j, k);
                const Equations cell(fine, row, kFirstColour, fine.value);
                const float* x = fine.value.colour[kFirstColour] + row.at;
                const float* b = fine.source.colour[kFirstColour] + row.at;
                const float* diagonal = fine.diagonal.colour[kFirstColour] + row.at;
                for (int m = row.begin; m < row.end; ++m)
                    sum[m] += (b[m] + cell.inflow(m)) - diagonal[m] * x[m];
            }
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(coarse, colour, coarse_j, coarse_k);
            float* __restrict b = coarse.source.colour[colour] + row.at;
            const float* own = sum + row.west + 1;
            for (int m = row.begin; m < row.end; ++m)
                b[m] = own[2 * m];
        }
    }
}

void add_correction(const LevelView& coarse, const LevelView& fine, int coarse_k) {
    float correction[2 * kMaxHalf];
    for (int coarse_j = 0; coarse_j < coarse.extent.ny; ++coarse_j) {
        // A fine row may reach further than the coarse one: where a coarse cell has no open face.
        for (int m = 0; m < fine.extent.half() + kGroup; ++m)
            correction[m] = 0.0F;
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(coarse, colour, coarse_j, coarse_k);
            const float* value = coarse.value.colour[colour] + row.at;
            float* own = correction + row.west + 1;
            for (int m = row.begin; m < row.end; ++m)
                own[2 * m] = value[m];
        }
        for (int k = 2 * coarse_k; k < 2 * coarse_k + 2 && k < fine.extent.nz; ++k)
            for (int j = 2 * coarse_j; j < 2 * coarse_j + 2 && j < fine.extent.ny; ++j) {
                const Row row = row_of(fine, kFirstColour, j, k);
                float* __restrict x = fine.value.colour[kFirstColour] + row.at;
                for (int m = row.begin; m < row.end; ++m)
                    x[m] += correction[m];
            }
    }
}

double start_residual(const LevelView& level, const ConjugateView& vectors, int k) {
    double sum = 0.0;
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(level, colour, j, k);
            const Equations cell(level, row, colour, vectors.solution);
            const float* x = vectors.solution.colour[colour] + row.at;
            const float* diagonal = level.diagonal.colour[colour] + row.at;
            float* __restrict r = level.source.colour[colour] + row.at;
            for (int m = row.begin; m < row.end; ++m)
                r[m] = (r[m] + cell.inflow(m)) - diagonal[m] * x[m];
            sum += product(r, r, row.begin, row.end);
        }
    return sum;
}

DirectionSums turn_direction(const LevelView& level, const ConjugateView& vectors, float beta, int k) {
    DirectionSums sum;
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = kFirstColour; colour <= kLastColour; ++colour) {
            const Row row = row_of(level, colour, j, k);
            const float* z = level.value.colour[colour] + row.at;
            float* __restrict direction = vectors.direction.colour[colour] + row.at;
            float* __restrict image = vectors.image.colour[colour] + row.at;
            if (colour == kFirstColour) {
                const float* r = level.source.colour[colour] + row.at;
                for (int m = row.begin; m < row.end; ++m) {
                    direction[m] = z[m] + beta * direction[m];
                    image[m] = r[m] + beta * image[m];
                }
            } else {
                const Equations cell(level, row, colour, level.value);
                const float* diagonal = level.diagonal.colour[colour] + row.at;
                for (int m = row.begin; m < row.end; ++m) {
                    direction[m] = z[m] + beta * direction[m];
                    image[m] = (diagonal[m] * z[m] - cell.inflow(m)) + beta * image[m];
                }
            }
            sum.product += product(direction, image, row.begin, row.end);
            sum.image += total(image, row.begin, row.end);
        }
    return sum;
}

double advance(const LevelView& level, const ConjugateView& vectors, float alpha, float mean, int k) {
    double sum = 0.0;
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(level, colour, j, k);
            float* __restrict x = vectors.solution.colour[colour] + row.at;
            float* __restrict r = level.source.colour[colour] + row.at;
            const float* direction = vectors.direction.colour[colour] + row.at;
            const float* image = vectors.image.colour[colour] + row.at;
            const float* inverse = level.inverse.colour[colour] + row.at;
            for (int m = row.begin; m < row.end; ++m) {
                x[m] += alpha * direction[m];
                r[m] -= alpha * (inverse[m] > 0.0F ? image[m] - mean : 0.0F);
            }
            sum += product(r, r, row.begin, row.end);
        }
    return sum;
}

double squared_source(const LevelView& level, int k) {
    double sum = 0.0;
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(level, colour, j, k);
            const float* b = level.source.colour[colour] + row.at;
            sum += product(b, b, row.begin, row.end);
        }
    return sum;
}

double total(const LevelView& level, const ColourPointers& values, int k) {
    double sum = 0.0;
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(level, colour, j, k);
            sum += total(values.colour[colour] + row.at, row.begin, row.end);
        }
    return sum;
}

void subtract(const LevelView& level, const ColourPointers& values, float mean, int k) {
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(level, colour, j, k);
            float* __restrict x = values.colour[colour] + row.at;
            const float* inverse = level.inverse.colour[colour] + row.at;
            for (int m = row.begin; m < row.end; ++m)
                x[m] -= inverse[m] > 0.0F ? mean : 0.0F;
        }
}

void split_row(const LevelView& level, const float* cells, const ColourPointers& out, int j, int k) {
    for (int colour = 0; colour < 2; ++colour) {
        const Row row = row_of(level, colour, j, k);
        const int parity = row.west + 1;
        float* __restrict values = out.colour[colour] + row.at;
        const float* inverse = level.inverse.colour[colour] + row.at;
        const float* own = cells + parity;
        const int last = (level.extent.nx - parity + 1) / 2, end = row.end < last ? row.end : last;
        for (int m = row.begin; m < end; ++m)
            values[m] = inverse[m] > 0.0F ? own[2 * m] : 0.0F;
    }
}

void merge_row(const LevelView& level, const ColourPointers& in, float* cells, int j, int k) {
    for (int colour = 0; colour < 2; ++colour) {
        const Row row = row_of(level, colour, j, k);
        const int parity = row.west + 1;
        const float* values = in.colour[colour] + row.at;
        float* __restrict own = cells + parity;
        const int last = (level.extent.nx - parity + 1) / 2, end = row.end < last ? row.end : last;
        for (int m = row.begin; m < end; ++m)
            own[2 * m] = values[m];
    }
}

}  // namespace pastoso::liquid::PASTOSO_ISA
