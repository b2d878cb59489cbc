// One V-cycle for the pressure p and the change of thickness d of a patch,
//     d + A p = f1,   p - S d = f2,   A = -div m grad,   S = g - (sigma/rho) div w grad,
// both zero outside the patch and beyond the canvas' open edges. The two unknowns of a cell are relaxed
// together, in checkerboard order. Compiled once per instruction set; see pastoso_add_kernels.
#include "film/face/lane_groups.hpp"
#include "film/large/large_kernels.hpp"
#include "film/large/multigrid_rows.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

/// g and sigma/(rho dx^2): how the pressure answers to thickness and to its bending.
struct Stiffness {
    float gravity, tension;
    explicit Stiffness(const StepConstants& step)
        : gravity(step.gravity_mm_s2), tension(step.tension * step.inverse_cell * step.inverse_cell) {}
};

template <int kWidth>
using Group = lanes::Lanes<float, kWidth>;

/// Calls body<V>(k) for groups that cover [0, count), count >= 4: as wide ones as fit into what is left,
/// the last one of four moved back.
template <class Body>
[[gnu::always_inline]] inline void for_each_group(int count, const Body& body) {
    int k = 0;
    for (; k + kLanes <= count; k += kLanes)
        body.template operator()<Lanes>(k);
    if (kLanes > 8 && k + 8 <= count) {
        body.template operator()<Group<8>>(k);
        k += 8;
    }
    for (; k < count; k += 4)
        body.template operator()<Group<4>>(std::min(k, count - 4));
}

/// Where the cells around those of one colour in a row stand: all of them are of the other colour.
struct Neighbours {
    int own, west, east, above, below;
};
Neighbours neighbours(const MultigridLevel& level, int y, int colour) {
    const int other = level.row(y, 1 - colour), parity = (y ^ colour) & 1;
    return {level.row(y, colour), other + parity - 1, other + parity, level.row(y - 1, 1 - colour),
            level.row(y + 1, 1 - colour)};
}

/// a = sum m and s = g + sigma' sum w over a cell's faces.
template <class V>
struct CellSums {
    V mobility, stiffness;
};
template <class V>
[[gnu::always_inline]] inline CellSums<V> cell_sums(const MultigridLevel& level, const Neighbours& at,
                                                    int k, const Stiffness& stiffness) {
    const auto sum = [&](const LevelValues& x_faces, const LevelValues& y_faces) {
        const auto value = [k](const LevelValues& values, int index) {
            return lanes::load<V>(values.data() + index + k);
        };
        return V((value(x_faces, at.own) + value(x_faces, at.west)) +
                 (value(y_faces, at.own) + value(y_faces, at.above)));
    };
    return {sum(level.mobility_x, level.mobility_y),
            V(V(stiffness.gravity) + V(stiffness.tension) * sum(level.weight_x, level.weight_y))};
}

/// A cell's equations d + a p = f1 + sum m p and p - s d = f2 - sigma' sum w d, the sums over its
/// neighbours, with a = sum m and s = g + sigma' sum w.
template <class V>
struct CellEquations {
    V change, pressure;  ///< right-hand sides
    V mobility, stiffness;
};
template <class V>
[[gnu::always_inline]] inline CellEquations<V> cell_equations(const MultigridLevel& level,
                                                              const Neighbours& at, int k,
                                                              const Stiffness& stiffness) {
    const auto value = [k](const LevelValues& values, int index) {
        return lanes::load<V>(values.data() + index + k);
    };
    const auto& p = level.pressure;
    const auto& d = level.change;
    const V m_east = value(level.mobility_x, at.own), m_west = value(level.mobility_x, at.west);
    const V m_below = value(level.mobility_y, at.own), m_above = value(level.mobility_y, at.above);
    const V w_east = value(level.weight_x, at.own), w_west = value(level.weight_x, at.west);
    const V w_below = value(level.weight_y, at.own), w_above = value(level.weight_y, at.above);
    const V tension(stiffness.tension);
    const V change = value(level.change_source, at.own) +
                     (m_east * value(p, at.east) + m_west * value(p, at.west)) +
                     (m_below * value(p, at.below) + m_above * value(p, at.above));
    const V bend = (w_east * value(d, at.east) + w_west * value(d, at.west)) +
                   (w_below * value(d, at.below) + w_above * value(d, at.above));
    return {change, value(level.pressure_source, at.own) - tension * bend,
            (m_east + m_west) + (m_below + m_above),
            V(stiffness.gravity) + tension * ((w_east + w_west) + (w_below + w_above))};
}

void clear_beyond(const MultigridLevel& level, LevelValues& values) {
    for_each_cell_beyond(level, [&](int x, int y) { values[level.cell(x, y)] = 0.0F; });
}
void hold_beyond(MultigridLevel& level) {
    clear_beyond(level, level.pressure);
    clear_beyond(level, level.change);
}

/// p = (q2 + s q1) / (1 + a s), d = q1 - a p in all cells of a colour.
void relax(MultigridLevel& level, const Stiffness& stiffness, int colour) {
    for (int y = 0; y < level.size; ++y) {
        const Neighbours at = neighbours(level, y, colour);
        for_each_group(level.half(), [&]<class V>(int k) {
            const CellEquations<V> cell = cell_equations<V>(level, at, k, stiffness);
            const V p = (cell.pressure + cell.stiffness * cell.change) *
                        lanes::load<V>(&level.inverse[at.own + k]);
            lanes::store(&level.pressure[at.own + k], p);
            lanes::store(&level.change[at.own + k], V(cell.change - cell.mobility * p));
        });
    }
    hold_beyond(level);
}

/// The same where p and d are zero all around, whatever the level holds there.
void relax_from_zero(MultigridLevel& level, const Stiffness& stiffness, int colour) {
    for (int y = 0; y < level.size; ++y) {
        const Neighbours at = neighbours(level, y, colour);
        for_each_group(level.half(), [&]<class V>(int k) {
            const CellSums<V> sums = cell_sums<V>(level, at, k, stiffness);
            const V change = lanes::load<V>(&level.change_source[at.own + k]);
            const V p = (lanes::load<V>(&level.pressure_source[at.own + k]) + sums.stiffness * change) *
                        lanes::load<V>(&level.inverse[at.own + k]);
            lanes::store(&level.pressure[at.own + k], p);
            lanes::store(&level.change[at.own + k], V(change - sums.mobility * p));
        });
    }
    hold_beyond(level);
}

/// The colour that a sweep relaxes first, and the one it leaves without residual.
constexpr int kFirstColour = 0, kLastColour = 1;

void smooth(MultigridLevel& level, const Stiffness& stiffness, int sweeps) {
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const int colour : {kFirstColour, kLastColour})
            relax(level, stiffness, colour);
}

/// The sweeps of a level that begins with nothing.
void smooth_from_zero(MultigridLevel& level, const Stiffness& stiffness, int sweeps) {
    relax_from_zero(level, stiffness, kFirstColour);
    relax(level, stiffness, kLastColour);
    smooth(level, stiffness, sweeps - 1);
}

/// The residual that a sweep leaves: none in the cells of its last colour.
void compute_residual(MultigridLevel& level, const Stiffness& stiffness) {
    for (int y = 0; y < level.size; ++y) {
        const Neighbours at = neighbours(level, y, kFirstColour);
        for_each_group(level.half(), [&]<class V>(int k) {
            const CellEquations<V> cell = cell_equations<V>(level, at, k, stiffness);
            const V p = lanes::load<V>(&level.pressure[at.own + k]);
            const V d = lanes::load<V>(&level.change[at.own + k]);
            lanes::store(&level.change_residual[at.own + k], V(cell.change - d - cell.mobility * p));
            lanes::store(&level.pressure_residual[at.own + k],
                         V(cell.pressure - (p - cell.stiffness * d)));
        });
    }
    clear_beyond(level, level.change_residual);
    clear_beyond(level, level.pressure_residual);
}

using PlainRow = std::array<float, kPatchSize + 2>;

/// The mean of the four fine cells' residuals, of which two are zero.
void restrict_mean(const MultigridLevel& fine, const LevelValues& residual, const MultigridLevel& coarse,
                   LevelValues& out) {
    PlainRow row;
    for (int y = 0; y < coarse.size; ++y) {
        const float* top = residual.data() + fine.row(2 * y, kFirstColour);
        const float* bottom = residual.data() + fine.row(2 * y + 1, kFirstColour);
        for_each_group(coarse.size, [&]<class V>(int k) {
            lanes::store(row.data() + k,
                         V(V(0.25F) * (lanes::load<V>(top + k) + lanes::load<V>(bottom + k))));
        });
        split_row(coarse, y, row.data(), out);
    }
}

/// Adds the coarse correction: d bilinear, p constant in a coarse cell.
void prolong(const MultigridLevel& coarse, MultigridLevel& fine) {
    std::array<PlainRow, 3> change{};
    PlainRow pressure{}, blend{};
    const auto read = [&](int y, PlainRow& row) {
        if (y >= coarse.size) return row.fill(0.0F);
        merge_row(coarse, y, coarse.change, row.data() + 1);
    };
    read(0, change[1]);
    for (int y = 0; y < coarse.size; ++y) {
        read(y + 1, change[2]);
        merge_row(coarse, y, coarse.pressure, pressure.data() + 1);
        for (const int lower : {0, 1}) {
            const int fine_y = 2 * y + lower;
            const PlainRow& here = change[1];
            const PlainRow& beside = change[lower == 1 ? 2 : 0];
            for (int x = 0; x < coarse.size + 2; ++x)
                blend[x] = 0.75F * here[x] + 0.25F * beside[x];
            const int even = fine.row(fine_y, fine_y & 1), odd = fine.row(fine_y, 1 - (fine_y & 1));
            for (int x = 0; x < coarse.size; ++x) {
                fine.change[even + x] += 0.75F * blend[x + 1] + 0.25F * blend[x];
                fine.change[odd + x] += 0.75F * blend[x + 1] + 0.25F * blend[x + 2];
                fine.pressure[even + x] += pressure[x + 1];
                fine.pressure[odd + x] += pressure[x + 1];
            }
        }
        change[0] = change[1];
        change[1] = change[2];
    }
    hold_beyond(fine);
}

/// Coarse coefficients at the faces behind coarse cells -1 .. size - 1: a quarter of the mean over the
/// two fine faces, with the mobility smoothed along the axis first (a lone shut face must not cut a
/// coarse cell off).
template <bool kSmooth>
void coarsen_x(const MultigridLevel& fine, const LevelValues& values, const MultigridLevel& coarse,
               LevelValues& out) {
    PlainRow row;
    const float* v = values.data();
    for (int y = 0; y < coarse.size; ++y) {
        const float* top = v + fine.row(2 * y, 1);
        const float* top_beside = v + fine.row(2 * y, 0);
        const float* bottom = v + fine.row(2 * y + 1, 0);
        const float* bottom_beside = v + fine.row(2 * y + 1, 1);
        for (int x = -1; x < coarse.size; ++x) {
            const float here = top[x] + bottom[x];
            const float beside =
                (top_beside[x] + top_beside[x + 1]) + (bottom_beside[x] + bottom_beside[x + 1]);
            row[x + 1] = 0.125F * (kSmooth ? 0.5F * here + 0.25F * beside : here);
        }
        split_row(coarse, y, row.data() + 1, out);
        out[coarse.row(y, 1 - (y & 1)) - 1] = row[0];
    }
}
template <bool kSmooth>
void coarsen_y(const MultigridLevel& fine, const LevelValues& values, const MultigridLevel& coarse,
               LevelValues& out) {
    PlainRow row;
    for (int y = -1; y < coarse.size; ++y) {
        const auto pair_sum = [&](int fine_y, int x) {
            if (fine_y < -1 || fine_y > fine.size) return 0.0F;
            const float* cells = values.data() + fine.row(fine_y, 0) + x;
            return cells[0] + cells[fine.stride()];
        };
        for (int x = 0; x < coarse.size; ++x) {
            const float here = pair_sum(2 * y + 1, x);
            const float beside = pair_sum(2 * y, x) + pair_sum(2 * y + 2, x);
            row[x] = 0.125F * (kSmooth ? 0.5F * here + 0.25F * beside : here);
        }
        split_row(coarse, y, row.data(), out);
    }
}

/// 1 / (1 + a s) of every cell.
void invert_cells(MultigridLevel& level, const Stiffness& stiffness) {
    for (int y = 0; y < level.size; ++y)
        for (const int colour : {kFirstColour, kLastColour}) {
            const Neighbours at = neighbours(level, y, colour);
            for_each_group(level.half(), [&]<class V>(int k) {
                const CellSums<V> sums = cell_sums<V>(level, at, k, stiffness);
                lanes::store(&level.inverse[at.own + k],
                             V(V(1.0F) / (V(1.0F) + sums.mobility * sums.stiffness)));
            });
        }
}

}  // namespace

void prepare_multigrid(const StepConstants& step, const grid::Rect& within, LargeScratch& scratch) {
    const Stiffness stiffness(step);
    MultigridLevel& finest = scratch.levels[0];
    finest.within = within;
    for (int y = -1; y < finest.size; ++y) {
        const int from = window_index(-kOverlap, y - kOverlap);
        split_row(finest, y, &scratch.mobility_y[from], finest.mobility_y);
        split_row(finest, y, &scratch.weight_y[from], finest.weight_y);
        if (y < 0) continue;
        split_row(finest, y, &scratch.mobility_x[from], finest.mobility_x);
        split_row(finest, y, &scratch.weight_x[from], finest.weight_x);
        const int before = finest.row(y, 1 - (y & 1)) - 1;
        finest.mobility_x[before] = scratch.mobility_x[from - 1];
        finest.weight_x[before] = scratch.weight_x[from - 1];
    }
    invert_cells(finest, stiffness);
    for (int depth = 1; depth < kMultigridLevels; ++depth) {
        const MultigridLevel& fine = scratch.levels[depth - 1];
        MultigridLevel& coarse = scratch.levels[depth];
        coarse.within = {fine.within.x0 / 2, fine.within.y0 / 2, (fine.within.x1 + 1) / 2,
                         (fine.within.y1 + 1) / 2};
        coarsen_x<true>(fine, fine.mobility_x, coarse, coarse.mobility_x);
        coarsen_y<true>(fine, fine.mobility_y, coarse, coarse.mobility_y);
        coarsen_x<false>(fine, fine.weight_x, coarse, coarse.weight_x);
        coarsen_y<false>(fine, fine.weight_y, coarse, coarse.weight_y);
        invert_cells(coarse, stiffness);
    }
}

void multigrid_cycle(const StepConstants& step, LargeScratch& scratch) {
    constexpr int kSweeps = 2, kCoarsestSweeps = 6;
    const Stiffness stiffness(step);
    for (int depth = 0; depth + 1 < kMultigridLevels; ++depth) {
        MultigridLevel& fine = scratch.levels[depth];
        MultigridLevel& coarse = scratch.levels[depth + 1];
        smooth_from_zero(fine, stiffness, kSweeps);
        compute_residual(fine, stiffness);
        restrict_mean(fine, fine.change_residual, coarse, coarse.change_source);
        restrict_mean(fine, fine.pressure_residual, coarse, coarse.pressure_source);
    }
    smooth_from_zero(scratch.levels.back(), stiffness, kCoarsestSweeps);
    for (int depth = kMultigridLevels - 2; depth >= 0; --depth) {
        prolong(scratch.levels[depth + 1], scratch.levels[depth]);
        smooth(scratch.levels[depth], stiffness, kSweeps);
    }
}

}  // namespace pastoso::film::PASTOSO_ISA
