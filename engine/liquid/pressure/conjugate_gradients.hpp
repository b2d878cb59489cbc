// Conjugate gradients with one V-cycle of multigrid as the preconditioner, for the equations of a
// CellMatrix.
//
// Each V-cycle relaxes in checkerboard order, first colour then last on the way down, the other way
// round on the way up, so that it is symmetric; coarse corrections are constant over a coarse cell. A
// V-cycle ends with a relaxation of the first colour, whose cells therefore fulfil A z = r: only the
// last colour's A z is computed, and the image of the direction follows its own recurrence (Chronopoulos
// and Gear 1989). Sums are taken slice by slice and added in order: the same bits on any number of
// threads.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/flow/kernels.hpp"
#include "liquid/pressure/multigrid_level.hpp"

#include <vector>

namespace pastoso::liquid {

struct SolveLimits {
    float tolerance = 1e-3F;  ///< of the residual against the source, both root-sum-square; 1e-7 to 1
    int max_iterations = 50;  ///< 1 or more
};
/// Throws core::InputError.
void check(const SolveLimits& limits);

struct SolveResult {
    int iterations = 0;
    float residual = 0.0F;  ///< what remains of the source
    bool converged = true;
    friend bool operator==(const SolveResult&, const SolveResult&) = default;
};

class ConjugateGradients {
  public:
    /// A kernel table other than the best one is for tests.
    explicit ConjugateGradients(const CellMatrix& matrix,
                                const Kernels& kernels = core::kernels<Kernels>());
    /// Without equations yet.
    explicit ConjugateGradients(const grid::BoxShape& shape,
                                const Kernels& kernels = core::kernels<Kernels>());
    ConjugateGradients(ConjugateGradients&&) = default;
    ConjugateGradients& operator=(ConjugateGradients&&) = default;

    /// Takes another matrix of the same shape, whose cells that take part lie within `rows`.
    void set_matrix(const CellMatrix& matrix, const RowRanges& rows, core::ThreadPool& pool);

    /// Solves A solution = source, beginning with the solution given where that is better than 0. Where
    /// a closed component (connected cells without boundary or mass) has a source whose mean is not
    /// zero, the mean is left out; its solution has mean zero. Cells that take no part get 0.
    SolveResult solve(const grid::BoxField& source, grid::BoxField& solution, const SolveLimits& limits,
                      core::ThreadPool& pool);

  private:
    std::vector<MultigridLevel>& levels() { return multigrid_.levels(); }
    const std::vector<MultigridLevel>& levels() const { return multigrid_.levels(); }
    void load(const grid::BoxField& cells, ColourField& out, core::ThreadPool& pool) const;
    void store(ColourField& values, grid::BoxField& cells, core::ThreadPool& pool) const;
    /// Of the level's closed components.
    void remove_means(const MultigridLevel& level, ColourField& values, core::ThreadPool& pool) const;
    double start_residual(core::ThreadPool& pool);
    SolveResult iterate(double source_norm, double residual, const SolveLimits& limits,
                        core::ThreadPool& pool);
    /// Leaves z = M r in the finest level's value; returns the sum of z r.
    double precondition(core::ThreadPool& pool);
    void cycle_down(std::size_t depth, core::ThreadPool& pool);
    void solve_coarsest(core::ThreadPool& pool);
    template <class Body>
    void for_level_slices(const MultigridLevel& level, core::ThreadPool& pool, int count,
                          const Body& body) const;

    const Kernels* kernels_;
    MultigridLevels multigrid_;
    std::vector<LevelView> views_;
    ColourField solution_, direction_, image_;
    grid::BoxShape shape_;
};

}  // namespace pastoso::liquid
