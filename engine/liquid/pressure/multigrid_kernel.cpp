// Half sweeps of a multigrid level and the vector operations of conjugate gradients, slice by slice.
// Compiled once per instruction set; see pastoso_add_kernels.
#include "core/lane_memory.hpp"
#include "liquid/flow/kernels.hpp"

namespace pastoso::liquid::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;

constexpr int kFirstColour = 0, kLastColour = 1;
constexpr int kMaxHalf = 512 / 2 + 2 * kGroup;

/// A group of cells of one colour. Rows are worked on in groups by name: left to the compiler, loops
/// over two to eight groups spend their time on what comes before and after them.
using Group = lanes::Lanes<float, kGroup>;

PASTOSO_LANE_FUNCTION Group load(const float* from) {
    return lanes::load<Group>(from);
}

/// One colour of a row: its cells of the range, and where the cells around them stand in the other
/// colour.
struct Row {
    std::ptrdiff_t at;  ///< m = 0
    int west;           ///< from m to the cell to the west; the one to the east stands one further
    int begin, end, plain_begin, plain_end;
};
PASTOSO_LANE_FUNCTION Row row_of(const LevelView& level, int colour, int j, int k) {
    const GroupRange range = level.rows[k * level.extent.ny + j];
    return {j * level.stride_y + k * level.stride_z,
            ((j + k + colour) & 1) - 1,
            range.begin,
            range.end,
            range.plain_begin,
            range.plain_end};
}

/// The values around a group of a row's cells, m the first of them.
struct Neighbours {
    const float* values;  ///< of the other colour
    std::ptrdiff_t to_west, stride_y, stride_z;

    PASTOSO_LANE_MEMBER Neighbours(const LevelView& level, const Row& row, int colour,
                                   const ColourPointers& of)
        : values(of.colour[1 - colour] + row.at),
          to_west(row.west),
          stride_y(level.stride_y),
          stride_z(level.stride_z) {}
    PASTOSO_LANE_MEMBER Group west(int m) const { return load(values + m + to_west); }
    PASTOSO_LANE_MEMBER Group east(int m) const { return load(values + m + to_west + 1); }
    PASTOSO_LANE_MEMBER Group south(int m) const { return load(values + m - stride_y); }
    PASTOSO_LANE_MEMBER Group north(int m) const { return load(values + m + stride_y); }
    PASTOSO_LANE_MEMBER Group below(int m) const { return load(values + m - stride_z); }
    PASTOSO_LANE_MEMBER Group above(int m) const { return load(values + m + stride_z); }
};

/// A row's equations, with the coefficients of each cell.
struct Equations {
    Neighbours x;
    const float *wests, *easts, *souths, *norths, *belows, *aboves;  ///< coefficients
    const float *diagonals, *inverses;

    PASTOSO_LANE_MEMBER Equations(const LevelView& level, const Row& row, int colour,
                                  const ColourPointers& values)
        : x(level, row, colour, values) {
        const int other = 1 - colour;
        const std::ptrdiff_t at = row.at;
        wests = level.west.colour[colour] + at;
        easts = level.west.colour[other] + at + row.west + 1;
        souths = level.south.colour[colour] + at;
        norths = level.south.colour[other] + at + level.stride_y;
        belows = level.below.colour[colour] + at;
        aboves = level.below.colour[other] + at + level.stride_z;
        diagonals = level.diagonal.colour[colour] + at;
        inverses = level.inverse.colour[colour] + at;
    }
    /// What the neighbours add to each cell: the sum of a_f x_f.
    PASTOSO_LANE_MEMBER Group inflow(int m) const {
        return ((load(wests + m) * x.west(m) + load(easts + m) * x.east(m)) +
                (load(souths + m) * x.south(m) + load(norths + m) * x.north(m))) +
               (load(belows + m) * x.below(m) + load(aboves + m) * x.above(m));
    }
    PASTOSO_LANE_MEMBER Group diagonal(int m) const { return load(diagonals + m); }
    PASTOSO_LANE_MEMBER Group inverse(int m) const { return load(inverses + m); }
};

/// The same numbers from the same operations, where all coefficients are those of the level.
struct PlainEquations {
    Neighbours x;
    Group coefficient, of_cell, over_cell;

    PASTOSO_LANE_MEMBER PlainEquations(const LevelView& level, const Row& row, int colour,
                                       const ColourPointers& values)
        : x(level, row, colour, values),
          coefficient(level.plain.coefficient),
          of_cell(level.plain.diagonal),
          over_cell(level.plain.inverse) {}
    PASTOSO_LANE_MEMBER Group inflow(int m) const {
        const Group a = coefficient;
        return ((a * x.west(m) + a * x.east(m)) + (a * x.south(m) + a * x.north(m))) +
               (a * x.below(m) + a * x.above(m));
    }
    PASTOSO_LANE_MEMBER Group diagonal(int) const { return of_cell; }
    PASTOSO_LANE_MEMBER Group inverse(int) const { return over_cell; }
};

/// Calls body(equations, m) for each group of a row, plain ones and others.
template <class Body>
PASTOSO_LANE_FUNCTION void for_groups(const LevelView& level, const Row& row, int colour,
                                      const ColourPointers& values, const Body& body) {
    const Equations cells(level, row, colour, values);
    for (int m = row.begin; m < row.plain_begin; m += kGroup)
        body(cells, m);
    const PlainEquations plain(level, row, colour, values);
    for (int m = row.plain_begin; m < row.plain_end; m += kGroup)
        body(plain, m);
    for (int m = row.plain_end; m < row.end; m += kGroup)
        body(cells, m);
}

/// A row's sum in kGroup lanes, each in its own order whatever the registers' width.
struct LaneSum {
    Group lane = Group(0.0F);
    PASTOSO_LANE_MEMBER void add(Group value) { lane += value; }
    PASTOSO_LANE_MEMBER double total() const {
        return (static_cast<double>((lane[0] + lane[4]) + (lane[2] + lane[6])) +
                static_cast<double>((lane[1] + lane[5]) + (lane[3] + lane[7])));
    }
};

PASTOSO_LANE_FUNCTION double product(const float* a, const float* b, int begin, int end) {
    LaneSum sum;
    for (int m = begin; m < end; m += kGroup)
        sum.add(load(a + m) * load(b + m));
    return sum.total();
}

PASTOSO_LANE_FUNCTION double total(const float* a, int begin, int end) {
    LaneSum sum;
    for (int m = begin; m < end; m += kGroup)
        sum.add(load(a + m));
    return sum.total();
}

// What is done to each group of a row.

struct FromZero {
    float* x;
    const float* b;
    template <class Cells>
    PASTOSO_LANE_MEMBER void operator()(const Cells& cells, int m) const {
        lanes::store(x + m, load(b + m) * cells.inverse(m));
    }
};
struct Relaxation {
    float* x;
    const float* b;
    template <class Cells>
    PASTOSO_LANE_MEMBER void operator()(const Cells& cells, int m) const {
        lanes::store(x + m, (load(b + m) + cells.inflow(m)) * cells.inverse(m));
    }
};
/// Adds up to `sum`.
struct Residual {
    const float *x, *b;
    float* sum;
    template <class Cells>
    PASTOSO_LANE_MEMBER void operator()(const Cells& cells, int m) const {
        lanes::store(sum + m, load(sum + m) +
                                  ((load(b + m) + cells.inflow(m)) - cells.diagonal(m) * load(x + m)));
    }
};
/// Takes A x away from r.
struct ImageTaken {
    const float* x;
    float* r;
    LaneSum& squares;
    template <class Cells>
    PASTOSO_LANE_MEMBER void operator()(const Cells& cells, int m) const {
        const Group left = (load(r + m) + cells.inflow(m)) - cells.diagonal(m) * load(x + m);
        lanes::store(r + m, left);
        squares.add(left * left);
    }
};
/// The direction of one colour and its image; `beta` of those before, which count for nothing if it is
/// the first.
struct Turn {
    const float* z;
    float *direction, *image;
    float beta;
    LaneSum &products, &images;

    PASTOSO_LANE_MEMBER void turn(Group image_of_z, int m) const {
        const bool is_first = beta == 0.0F;
        const Group along = is_first ? load(z + m) : load(z + m) + Group(beta) * load(direction + m),
                    seen = is_first ? image_of_z : image_of_z + Group(beta) * load(image + m);
        lanes::store(direction + m, along);
        lanes::store(image + m, seen);
        products.add(along * seen);
        images.add(seen);
    }
    template <class Cells>
    PASTOSO_LANE_MEMBER void operator()(const Cells& cells, int m) const {
        turn(cells.diagonal(m) * load(z + m) - cells.inflow(m), m);
    }
};
struct Advance {
    const float *direction, *image;
    float *solution, *residual;
    float alpha, mean;
    LaneSum& squares;
    template <class Cells>
    PASTOSO_LANE_MEMBER void operator()(const Cells& cells, int m) const {
        const Group zero(0.0F), step(alpha);
        lanes::store(solution + m, load(solution + m) + step * load(direction + m));
        const Group left =
            load(residual + m) -
            step * lanes::select(cells.inverse(m) > zero, load(image + m) - Group(mean), zero);
        lanes::store(residual + m, left);
        squares.add(left * left);
    }
};

PASTOSO_LANE_FUNCTION void relax_row(const LevelView& level, const Row& row, int colour) {
    for_groups(level, row, colour, level.value,
               Relaxation{level.value.colour[colour] + row.at, level.source.colour[colour] + row.at});
}

}  // namespace

void relax_from_zero(const LevelView& level, int k) {
    for (int j = 0; j < level.extent.ny; ++j) {
        const Row row = row_of(level, kFirstColour, j, k);
        for_groups(level, row, kFirstColour, level.value,
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
                for_groups(fine, row, kFirstColour, fine.value,
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
            LaneSum squares;
            for_groups(level, row, colour, vectors.solution,
                       ImageTaken{vectors.solution.colour[colour] + row.at,
                                  level.source.colour[colour] + row.at, squares});
            sum += squares.total();
        }
    return sum;
}

DirectionSums turn_direction(const LevelView& level, const ConjugateView& vectors, float beta, int k) {
    DirectionSums sum;
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = kFirstColour; colour <= kLastColour; ++colour) {
            const Row row = row_of(level, colour, j, k);
            LaneSum products, images;
            const Turn turn = {level.value.colour[colour] + row.at,
                               vectors.direction.colour[colour] + row.at,
                               vectors.image.colour[colour] + row.at,
                               beta,
                               products,
                               images};
            if (colour == kFirstColour) {
                // Just relaxed, it has no residual: the image of z is the source.
                const float* r = level.source.colour[colour] + row.at;
                for (int m = row.begin; m < row.end; m += kGroup)
                    turn.turn(load(r + m), m);
            } else {
                for_groups(level, row, colour, level.value, turn);
            }
            sum.product += products.total();
            sum.image += images.total();
        }
    return sum;
}

double advance(const LevelView& level, const ConjugateView& vectors, float alpha, float mean, int k) {
    double sum = 0.0;
    for (int j = 0; j < level.extent.ny; ++j)
        for (int colour = 0; colour < 2; ++colour) {
            const Row row = row_of(level, colour, j, k);
            LaneSum squares;
            for_groups(
                level, row, colour, level.value,
                Advance{vectors.direction.colour[colour] + row.at, vectors.image.colour[colour] + row.at,
                        vectors.solution.colour[colour] + row.at, level.source.colour[colour] + row.at,
                        alpha, mean, squares});
            sum += squares.total();
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
