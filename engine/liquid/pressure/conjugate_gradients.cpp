#include "liquid/pressure/conjugate_gradients.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "liquid/flow/slices.hpp"

#include <cmath>
#include <numeric>
#include <string>

namespace pastoso::liquid {
namespace {

/// Levels with fewer cells are worked on by one thread: waking others would cost more.
constexpr long kLeastCellsForThreads = 8000;
constexpr int kCoarsestSweeps = 12;
constexpr int kFirstColour = 0, kLastColour = 1;
/// When conjugate gradients count as stalled; until then the residual may rise for a while.
constexpr double kSmallResidual = 1e-4, kGrownTooFar = 4.0;

/// Whether one closed component is all there is, as in a vessel without free surface.
bool all_closed(const MultigridLevel& level) {
    return level.closed.count == 1 && level.closed.sizes[1] == level.cell_count;
}

}  // namespace

void check(const SolveLimits& limits) {
    if (!(limits.tolerance >= 1e-7F && limits.tolerance <= 1.0F))
        throw core::InputError("The pressure's tolerance is %1; it may be 1e-7 to 1.",
                               std::to_string(limits.tolerance));
    if (limits.max_iterations < 1)
        throw core::InputError("The pressure is allowed %1 iterations; it needs at least 1.",
                               limits.max_iterations);
}

ConjugateGradients::ConjugateGradients(const grid::BoxShape& shape, const Kernels& kernels)
    : kernels_(&kernels),
      multigrid_(shape),
      solution_(multigrid_.levels().front().extent),
      direction_(solution_),
      image_(solution_),
      shape_(shape) {}

ConjugateGradients::ConjugateGradients(const CellMatrix& matrix, const Kernels& kernels)
    : ConjugateGradients(matrix.shape(), kernels) {
    core::ThreadPool this_thread(1);
    set_matrix(matrix, RowRanges::whole(shape_, Location::Cell), this_thread);
}

void ConjugateGradients::set_matrix(const CellMatrix& matrix, const RowRanges& rows,
                                    core::ThreadPool& pool) {
    PASTOSO_CHECK(matrix.shape() == shape_);
    multigrid_.set_matrix(matrix, rows, pool);
    views_.clear();
    for (MultigridLevel& level : levels())
        views_.push_back(level.view());
}

template <class Body>
void ConjugateGradients::for_level_slices(const MultigridLevel& level, core::ThreadPool& pool, int count,
                                          const Body& body) const {
    if (level.cell_count >= kLeastCellsForThreads) return for_slices(pool, 0, count, body);
    for (int k = 0; k < count; ++k)
        body(k);
}

void ConjugateGradients::load(const grid::BoxField& cells, ColourField& out,
                              core::ThreadPool& pool) const {
    const ColourPointers pointers = out.data();
    for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j)
            kernels_->split_row(views_.front(), cells.row(j, k), pointers, j, k);
    });
}

void ConjugateGradients::store(ColourField& values, grid::BoxField& cells,
                               core::ThreadPool& pool) const {
    const ColourPointers pointers = values.data();
    for_slices(pool, 0, shape_.nz, [&](int k) {
        for (int j = 0; j < shape_.ny; ++j) {
            std::fill_n(cells.row(j, k), shape_.nx, 0.0F);
            kernels_->merge_row(views_.front(), pointers, cells.row(j, k), j, k);
        }
    });
}

void ConjugateGradients::remove_means(const MultigridLevel& level, ColourField& values,
                                      core::ThreadPool& pool) const {
    const ClosedComponents& closed = level.closed;
    const LevelExtent& extent = level.extent;
    if (closed.count == 0) return;
    if (all_closed(level)) {
        const LevelView& view = views_[static_cast<std::size_t>(&level - levels().data())];
        const ColourPointers pointers = values.data();
        std::vector<double> sums(static_cast<std::size_t>(extent.nz));
        for_level_slices(level, pool, extent.nz, [&](int k) {
            sums[static_cast<std::size_t>(k)] = kernels_->total(view, pointers, k);
        });
        const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
        const float mean = static_cast<float>(sum / static_cast<double>(level.cell_count));
        for_level_slices(level, pool, extent.nz,
                         [&](int k) { kernels_->subtract(view, pointers, mean, k); });
        return;
    }
    const auto count = static_cast<std::size_t>(closed.count) + 1;
    std::vector<std::vector<double>> sums(static_cast<std::size_t>(extent.nz),
                                          std::vector<double>(count));
    const auto for_cells = [&](int k, const auto& body) {
        const int* component =
            closed.of_cell.data() + static_cast<std::ptrdiff_t>(k) * extent.ny * extent.nx;
        for (int j = 0; j < extent.ny; ++j)
            for (int i = 0; i < extent.nx; ++i, ++component)
                if (*component != 0) body(values.at(i, j, k), static_cast<std::size_t>(*component));
    };
    for_level_slices(level, pool, extent.nz, [&](int k) {
        for_cells(k,
                  [&, &slice = sums[static_cast<std::size_t>(k)]](float value, std::size_t component) {
                      slice[component] += static_cast<double>(value);
                  });
    });
    std::vector<float> means(count);
    for (std::size_t component = 1; component < count; ++component) {
        double sum = 0.0;
        for (const auto& slice : sums)
            sum += slice[component];
        means[component] = static_cast<float>(sum / static_cast<double>(closed.sizes[component]));
    }
    for_level_slices(level, pool, extent.nz, [&](int k) {
        for_cells(k, [&](float& value, std::size_t component) { value -= means[component]; });
    });
}

SolveResult ConjugateGradients::solve(const grid::BoxField& source, grid::BoxField& solution,
                                      const SolveLimits& limits, core::ThreadPool& pool) {
    PASTOSO_CHECK(source.shape() == shape_ && solution.shape() == shape_);
    check(limits);
    MultigridLevel& finest = levels().front();
    load(source, finest.source, pool);
    load(solution, solution_, pool);
    remove_means(finest, finest.source, pool);
    const double source_norm = std::sqrt(sum_over_slices(
        pool, shape_.nz, [&](int k) { return kernels_->squared_source(views_.front(), k); }));
    SolveResult result;
    if (source_norm > 0.0) {
        double residual = start_residual(pool);
        if (residual > source_norm) {
            // The solution given is worse than none.
            solution_.fill(0.0F);
            load(source, finest.source, pool);
            remove_means(finest, finest.source, pool);
            residual = source_norm;
        }
        result = iterate(source_norm, residual, limits, pool);
    } else {
        solution_.fill(0.0F);
    }
    remove_means(finest, solution_, pool);
    store(solution_, solution, pool);
    return result;
}

double ConjugateGradients::start_residual(core::ThreadPool& pool) {
    const ConjugateView vectors = {solution_.data(), direction_.data(), image_.data()};
    return std::sqrt(sum_over_slices(
        pool, shape_.nz, [&](int k) { return kernels_->start_residual(views_.front(), vectors, k); }));
}

SolveResult ConjugateGradients::iterate(double source_norm, double residual, const SolveLimits& limits,
                                        core::ThreadPool& pool) {
    const LevelView& level = views_.front();
    const ConjugateView vectors = {solution_.data(), direction_.data(), image_.data()};
    const bool closed = all_closed(levels().front());
    const auto sum = [&](const auto& slice) { return sum_over_slices(pool, shape_.nz, slice); };
    SolveResult result;
    double product = 0.0, least_residual = residual;
    // Below the precision of the solution's own gradient nothing is gained: then the residual grows
    // again.
    const auto stalls = [&] {
        return least_residual < kSmallResidual * source_norm && residual > kGrownTooFar * least_residual;
    };
    while (residual > static_cast<double>(limits.tolerance) * source_norm &&
           result.iterations < limits.max_iterations && !stalls()) {
        const double new_product = precondition(pool);
        const float beta = result.iterations == 0 ? 0.0F : static_cast<float>(new_product / product);
        product = new_product;
        const DirectionSums turned =
            sum([&](int k) { return kernels_->turn_direction(level, vectors, beta, k); });
        if (!(product > 0.0) || !(turned.product > 0.0)) break;
        const float alpha = static_cast<float>(product / turned.product);
        // The image of a closed system has mean zero but for rounding, which must not gather in the
        // residual.
        const float mean =
            closed ? static_cast<float>(turned.image / static_cast<double>(levels().front().cell_count))
                   : 0.0F;
        residual =
            std::sqrt(sum([&](int k) { return kernels_->advance(level, vectors, alpha, mean, k); }));
        if (!closed) remove_means(levels().front(), levels().front().source, pool);
        least_residual = std::min(least_residual, residual);
        ++result.iterations;
    }
    result.residual = static_cast<float>(residual / source_norm);
    result.converged = result.residual <= limits.tolerance;
    return result;
}

double ConjugateGradients::precondition(core::ThreadPool& pool) {
    const std::size_t coarsest = levels().size() - 1;
    for (std::size_t depth = 0; depth < coarsest; ++depth)
        cycle_down(depth, pool);
    solve_coarsest(pool);
    for (std::size_t depth = coarsest; depth-- > 0;) {
        const LevelView &fine = views_[depth], &coarse = views_[depth + 1];
        for_level_slices(levels()[depth], pool, coarse.extent.nz,
                         [&](int k) { kernels_->add_correction(coarse, fine, k); });
        for_level_slices(levels()[depth], pool, fine.extent.nz,
                         [&](int k) { kernels_->relax(fine, kLastColour, k); });
        if (depth == 0) break;
        for_level_slices(levels()[depth], pool, fine.extent.nz,
                         [&](int k) { kernels_->relax(fine, kFirstColour, k); });
    }
    return sum_over_slices(pool, shape_.nz,
                           [&](int k) { return kernels_->relax_and_multiply(views_.front(), k); });
}

void ConjugateGradients::cycle_down(std::size_t depth, core::ThreadPool& pool) {
    const LevelView &fine = views_[depth], &coarse = views_[depth + 1];
    for_level_slices(levels()[depth], pool, fine.extent.nz,
                     [&](int k) { kernels_->relax_from_zero(fine, k); });
    for_level_slices(levels()[depth], pool, fine.extent.nz,
                     [&](int k) { kernels_->relax(fine, kLastColour, k); });
    for_level_slices(levels()[depth], pool, coarse.extent.nz,
                     [&](int k) { kernels_->restrict_residual(fine, coarse, k); });
}

void ConjugateGradients::solve_coarsest(core::ThreadPool& pool) {
    const LevelView& level = views_.back();
    // In a closed component the sources have mean zero but for rounding. Each sweep would turn what is
    // left into a constant, which conjugate gradients then take for a direction.
    remove_means(levels().back(), levels().back().source, pool);
    const auto relax = [&](int colour) {
        for (int k = 0; k < level.extent.nz; ++k)
            kernels_->relax(level, colour, k);
    };
    for (int k = 0; k < level.extent.nz; ++k)
        kernels_->relax_from_zero(level, k);
    relax(kLastColour);
    for (int sweep = 0; sweep < kCoarsestSweeps; ++sweep) {
        relax(kFirstColour);
        relax(kLastColour);
    }
    // Back in the opposite order, which keeps the preconditioner symmetric.
    for (int sweep = 0; sweep <= kCoarsestSweeps; ++sweep) {
        relax(kLastColour);
        relax(kFirstColour);
    }
}

}  // namespace pastoso::liquid
