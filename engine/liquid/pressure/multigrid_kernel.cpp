// Half sweeps of a multigrid level and the vector operations of conjugate gradients, slice by slice.
// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/flow/kernels.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

constexpr int kFirstColour = 0, kLastColour = 1;
constexpr int kMaxHalf = 512 / 2 + 2 * kGroup;

/// One colour of a row: its cells of the range, and where the cells around them stand in the other
/// colour.
struct Row {
    std::ptrdiff_t at;  ///< m = 0
    int west;           ///< from m to the cell to the west; the one to the east stands one further
    int begin, end, plain_begin, plain_end;
};
[[gnu::always_inline]] inline Row row_of(const LevelView& level, int colour, int j, int k) {
    const GroupRange range = level.rows[k * level.extent.ny + j];
    return {j * level.stride_y + k * level.stride_z,
            ((j + k + colour) & 1) - 1,
            range.begin,
            range.end,
            range.plain_begin,
            range.plain_end};
}

/// The values around a row's cells.
struct Neighbours {
    const float *west, *east, *south, *north, *below, *above;

    [[gnu::always_inline]] Neighbours(const LevelView& level, const Row& row, int colour,
                                      const ColourPointers& values) {
        const float* x = values.colour[1 - colour] + row.at;
        west = x + row.west;
        east = x + row.west + 1;
        south = x - level.stride_y;
        north = x + level.stride_y;
        below = x - level.stride_z;
        above = x + level.stride_z;
    }
};

/// A row's equations, with the coefficients of each cell.
struct Equations {
    Neighbours x;
    const float *west, *east, *south, *north, *below, *above;  ///< coefficients
    const float *diagonals, *inverses;

    [[gnu::always_inline]] Equations(const LevelView& level, const Row& row, int colour,
                                     const ColourPointers& values)
        : x(level, row, colour, values) {
        const int other = 1 - colour;
        const std::ptrdiff_t at = row.at;
        west = level.west.colour[colour] + at;
        east = level.west.colour[other] + at + row.west + 1;
        south = level.south.colour[colour] + at;
        north = level.south.colour[other] + at + level.stride_y;
        below = level.below.colour[colour] + at;
        above = level.below.colour[other] + at + level.stride_z;
        diagonals = level.diagonal.colour[colour] + at;
        inverses = level.inverse.colour[colour] + at;
    }
    /// What the neighbours add to cell m: the sum of a_f x_f.
    [[gnu::always_inline]] float inflow(int m) const {
        return ((west[m] * x.west[m] + east[m] * x.east[m]) +
                (south[m] * x.south[m] + north[m] * x.north[m])) +
               (below[m] * x.below[m] + above[m] * x.above[m]);
    }
    [[gnu::always_inline]] float diagonal(int m) const { return diagonals[m]; }
    [[gnu::always_inline]] float inverse(int m) const { return inverses[m]; }
};

/// The same numbers from the same operations, where all coefficients are those of the level.
struct PlainEquations {
    Neighbours x;
    PlainEquation plain;

    [[gnu::always_inline]] PlainEquations(const LevelView& level, const Row& row, int colour,
                                          const ColourPointers& values)
        : x(level, row, colour, values), plain(level.plain) {}
    [[gnu::always_inline]] float inflow(int m) const {
        const float a = plain.coefficient;
        return ((a * x.west[m] + a * x.east[m]) + (a * x.south[m] + a * x.north[m])) +
               (a * x.below[m] + a * x.above[m]);
    }
    [[gnu::always_inline]] float diagonal(int) const { return plain.diagonal; }
    [[gnu::always_inline]] float inverse(int) const { return plain.inverse; }
};

/// Calls body(equations, begin, end) for the parts of a row, plain ones and others.
template <class Body>
[[gnu::always_inline]] inline void for_parts(const LevelView& level, const Row& row, int colour,
                                             const ColourPointers& values, const Body& body) {
    const Equations cells(level, row, colour, values);
    body(cells, row.begin, row.plain_begin);
    body(PlainEquations(level, row, colour, values), row.plain_begin, row.plain_end);
    body(cells, row.plain_end, row.end);
}

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

// The loops over the cells of a part. What they write overlaps nothing that they read but at m itself,
// which the compiler cannot see (and would check at run time, if the pointers were fewer).

struct FromZero {
    float* x;
    const float* b;
    template <class Cells>
    [[gnu::always_inline]] void operator()(const Cells& cell, int begin, int end) const {
#pragma GCC ivdep
        for (int m = begin; m < end; ++m)
            x[m] = b[m] * cell.inverse(m);
    }
};
struct Relaxation {
    float* x;
    const float* b;
    template <class Cells>
    [[gnu::always_inline]] void operator()(const Cells& cell, int begin, int end) const {
#pragma GCC ivdep
        for (int m = begin; m < end; ++m)
            x[m] = (b[m] + cell.inflow(m)) * cell.inverse(m);
    }
};
/// Adds up to `sum`.
struct Residual {
    const float *x, *b;
    float* sum;
    template <class Cells>
    [[gnu::always_inline]] void operator()(const Cells& cell, int begin, int end) const {
#pragma GCC ivdep
        for (int m = begin; m < end; ++m)
            sum[m] += (b[m] + cell.inflow(m)) - cell.diagonal(m) * x[m];
    }
};
/// Takes A x away from r.
struct ImageTaken {
    const float* x;
    float* r;
    template <class Cells>
    [[gnu::always_inline]] void operator()(const Cells& cell, int begin, int end) const {
#pragma GCC ivdep
        for (int m = begin; m < end; ++m)
            r[m] = (r[m] + cell.inflow(m)) - cell.diagonal(m) * x[m];
    }
};
/// Without a direction before it.
struct FirstTurn {
    const float* z;
    float *direction, *image;
    template <class Cells>
    [[gnu::always_inline]] void operator()(const Cells& cell, int begin, int end) const {
#pragma GCC ivdep
        for (int m = begin; m < end; ++m) {
            direction[m] = z[m];
            image[m] = cell.diagonal(m) * z[m] - cell.inflow(m);
        }
    }
};
struct LastTurn {
    const float* z;
    float *direction, *image;
    float beta;
    template <class Cells>
    [[gnu::always_inline]] void operator()(const Cells& cell, int begin, int end) const {
#pragma GCC ivdep
        for (int m = begin; m < end; ++m) {
            direction[m] = z[m] + beta * direction[m];
            image[m] = (cell.diagonal(m) * z[m] - cell.inflow(m)) + beta * image[m];
        }
    }
};
struct Advance {
    const float *direction, *image;
    float *solution, *residual;
    float alpha, mean;
    template <class Cells>
    [[gnu::always_inline]] void operator()(const Cells& cell, int begin, int end) const {
#pragma GCC ivdep
        for (int m = begin; m < end; ++m) {
            solution[m] += alpha * direction[m];
            residual[m] -= alpha * (cell.inverse(m) > 0.0F ? image[m] - mean : 0.0F);
        }
    }
};

[[gnu::always_inline]] inline void relax_row(const LevelView& level, const Row& row, int colour) {
    for_parts(level, row, colour, level.value,
              Relaxation{level.value.colour[colour] + row.at, level.source.colour[colour] + row.at});
}

}  // namespace

void relax_from_zero(const LevelView& level, int k) {
    for (int j = 0; j < level.extent.ny; ++j) {
        const Row row = row_of(level, kFirstColour, j, k);
        for_parts(level, row, kFirstColour, level.value,
                  FromZero{level.value.colour[kFirstColour] + row.at,
                           level.source.colour[kFirstColour] + row.at});
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
                for_parts(fine, row, kFirstColour, fine.value,
                          Residual{fine.value.colour[kFirstColour] + row.at,
                                   fine.source.colour[kFirstColour] + row.at, sum});
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
            float* r = level.source.colour[colour] + row.at;
            for_parts(level, row, colour, vectors.solution,
                      ImageTaken{vectors.solution.colour[colour] + row.at, r});
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
            if (colour == kFirstColour && beta == 0.0F) {
                const float* r = level.source.colour[colour] + row.at;
                for (int m = row.begin; m < row.end; ++m) {
                    direction[m] = z[m];
                    image[m] = r[m];
                }
            } else if (beta == 0.0F) {
                for_parts(level, row, colour, level.value, FirstTurn{z, direction, image});
            } else if (colour == kFirstColour) {
                const float* r = level.source.colour[colour] + row.at;
                for (int m = row.begin; m < row.end; ++m) {
                    direction[m] = z[m] + beta * direction[m];
                    image[m] = r[m] + beta * image[m];
                }
            } else {
                for_parts(level, row, colour, level.value, LastTurn{z, direction, image, beta});
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
            const float* r = level.source.colour[colour] + row.at;
            for_parts(
                level, row, colour, level.value,
                Advance{vectors.direction.colour[colour] + row.at, vectors.image.colour[colour] + row.at,
                        vectors.solution.colour[colour] + row.at, level.source.colour[colour] + row.at,
                        alpha, mean});
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
