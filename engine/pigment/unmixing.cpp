#include "pigment/unmixing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pastoso::pigment {
namespace {

/// What the film's whole quanta and a brush's rounding leave of a mixture.
constexpr double kRounding = 0.001;

/// Channels far below the largest are not compared finer than this share of it.
constexpr double kLeastOfLargest = 1e-3;

/// A gradient or a share below this is 0: well above the rounding of double, far below what is unseen.
constexpr double kNothing = 1e-9;

using Channels = std::array<double, kChannels>;

/// A row of the mixture's relative errors is the sum of share times column, less `wanted`.
struct Problem {
    std::vector<Channels> columns;
    Channels wanted{};
};

Problem problem_of(const Coefficients& mixture, std::span<const Coefficients> paints) {
    const double largest = *std::max_element(mixture.begin(), mixture.end());
    Problem problem;
    problem.columns.resize(paints.size());
    for (int k = 0; k < kChannels; ++k) {
        const double unit = std::max<double>(mixture[k], kLeastOfLargest * largest);
        problem.wanted[k] = mixture[k] / unit;
        for (std::size_t i = 0; i < paints.size(); ++i)
            problem.columns[i][k] = paints[i][k] / unit;
    }
    return problem;
}

double dot(const Channels& a, const Channels& b) {
    double sum = 0.0;
    for (int k = 0; k < kChannels; ++k)
        sum += a[k] * b[k];
    return sum;
}

Channels residual(const Problem& problem, const std::vector<double>& shares) {
    Channels left = problem.wanted;
    for (std::size_t i = 0; i < shares.size(); ++i)
        for (int k = 0; k < kChannels; ++k)
            left[k] -= shares[i] * problem.columns[i][k];
    return left;
}

double error_of(const Problem& problem, const std::vector<double>& shares) {
    const Channels left = residual(problem, shares);
    return std::sqrt(dot(left, left) / kChannels);
}

/// The shares of these paints alone, of either sign: least squares by Gram and Schmidt's orthogonal
/// columns, modified for its rounding. A paint that is a mixture of those before it gets none.
std::vector<double> free_shares(const Problem& problem, const std::vector<std::size_t>& used) {
    std::vector<Channels> orthogonal;
    std::vector<std::vector<double>> upper(used.size(), std::vector<double>(used.size()));
    std::vector<double> along(used.size());
    Channels wanted = problem.wanted;
    for (std::size_t j = 0; j < used.size(); ++j) {
        Channels column = problem.columns[used[j]];
        const double length = std::sqrt(dot(column, column));
        for (std::size_t i = 0; i < j; ++i) {
            upper[i][j] = dot(orthogonal[i], column);
            for (int k = 0; k < kChannels; ++k)
                column[k] -= upper[i][j] * orthogonal[i][k];
        }
        upper[j][j] = std::sqrt(dot(column, column));
        const double scale = upper[j][j] > kNothing * length ? 1.0 / upper[j][j] : 0.0;
        for (double& value : column)
            value *= scale;
        along[j] = dot(column, wanted);
        for (int k = 0; k < kChannels; ++k)
            wanted[k] -= along[j] * column[k];
        orthogonal.push_back(column);
    }
    std::vector<double> shares(used.size());
    for (std::size_t j = used.size(); j-- > 0;) {
        double sum = along[j];
        for (std::size_t i = j + 1; i < used.size(); ++i)
            sum -= upper[j][i] * shares[i];
        shares[j] = along[j] == 0.0 ? 0.0 : sum / upper[j][j];
    }
    return shares;
}

/// Goes from `shares` towards the free shares of the paints used as far as none becomes negative, and
/// drops those that become 0; again until none does.
void settle(const Problem& problem, std::vector<std::size_t>& used, std::vector<double>& shares) {
    while (!used.empty()) {
        const std::vector<double> target = free_shares(problem, used);
        double step = 1.0;
        for (std::size_t j = 0; j < used.size(); ++j) {
            const double from = shares[used[j]];
            if (target[j] < kNothing) step = std::min(step, from / std::max(from - target[j], kNothing));
        }
        for (std::size_t j = 0; j < used.size(); ++j)
            shares[used[j]] += step * (target[j] - shares[used[j]]);
        const auto spent = [&](std::size_t i) { return shares[i] < kNothing; };
        for (const std::size_t i : used)
            if (spent(i)) shares[i] = 0.0;
        if (std::erase_if(used, spent) == 0) return;
    }
}

/// The paint not used yet that would bring the mixture nearest, or the number of paints.
std::size_t most_wanted(const Problem& problem, const std::vector<std::size_t>& used,
                        const std::vector<double>& shares) {
    const Channels left = residual(problem, shares);
    std::size_t best = problem.columns.size();
    double steepest = kNothing;
    for (std::size_t i = 0; i < problem.columns.size(); ++i) {
        const Channels& column = problem.columns[i];
        const double length = std::sqrt(dot(column, column));
        const bool taken = std::find(used.begin(), used.end(), i) != used.end();
        const double slope = length > 0.0 ? dot(column, left) / length : 0.0;
        if (taken || slope <= steepest) continue;
        steepest = slope;
        best = i;
    }
    return best;
}

/// Non-negative least squares with the paints allowed.
std::vector<double> best_shares(const Problem& problem) {
    std::vector<double> shares(problem.columns.size());
    std::vector<std::size_t> used;
    const std::size_t most_steps = 3 * problem.columns.size();
    for (std::size_t step = 0; step < most_steps; ++step) {
        const std::size_t next = most_wanted(problem, used, shares);
        if (next == problem.columns.size()) break;
        used.push_back(next);
        settle(problem, used, shares);
    }
    return shares;
}

/// The shares of the one or two paints that mix to it, or none where two are not enough.
std::vector<double> shares_of_two(const Problem& problem) {
    std::vector<double> best;
    double least_error = kRounding;
    const std::size_t count = problem.columns.size();
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = a; b < count; ++b) {
            const std::vector<std::size_t> used = a == b ? std::vector{a} : std::vector{a, b};
            const std::vector<double> found = free_shares(problem, used);
            if (*std::min_element(found.begin(), found.end()) < 0.0) continue;
            std::vector<double> shares(count);
            for (std::size_t i = 0; i < used.size(); ++i)
                shares[used[i]] = found[i];
            const double error = error_of(problem, shares);
            if (error >= least_error) continue;
            least_error = error;
            best = shares;
        }
    }
    return best;
}

/// The best shares without one more of the paints, or none where that is no longer the mixture.
std::vector<double> simpler(const Problem& problem, const std::vector<double>& shares) {
    std::vector<double> best;
    double least_error = kRounding;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (shares[i] == 0.0) continue;
        Problem fewer = problem;
        for (std::size_t j = 0; j < shares.size(); ++j)
            if (j == i || shares[j] == 0.0) fewer.columns[j] = {};
        const std::vector<double> tried = best_shares(fewer);
        const double error = error_of(fewer, tried);
        if (error >= least_error) continue;
        least_error = error;
        best = tried;
    }
    return best;
}

}  // namespace

Unmixed unmixed(const Coefficients& mixture, std::span<const Coefficients> paints) {
    if (*std::max_element(mixture.begin(), mixture.end()) <= 0.0F)
        return {std::vector<double>(paints.size()), 0.0};
    const Problem problem = problem_of(mixture, paints);
    std::vector<double> shares = shares_of_two(problem);
    if (shares.empty()) shares = best_shares(problem);
    for (std::vector<double> fewer = simpler(problem, shares); !fewer.empty();
         fewer = simpler(problem, shares))
        shares = fewer;
    return {shares, error_of(problem, shares)};
}

}  // namespace pastoso::pigment
