#include "pigment/smooth_bands.hpp"

#include "pigment/lab.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pastoso::pigment {
namespace {

/// Middles of the bands' windows (resources/pigments/bands_6.json).
constexpr std::array<double, kBands> kBandCentres_nm = {449.33, 496.65, 528.39, 564.42, 596.19, 641.25};

constexpr int kSlopes = kBands - 1;
constexpr int kResiduals = 3 + kSlopes;

/// Beyond this the sigmoid is flat to seven digits, and a step could not find back.
constexpr double kSteepest = 300.0;

using Unknowns = std::array<double, kBands>;
using Matrix = std::array<std::array<double, kBands>, kBands>;

double sigmoid(double z) {
    return 0.5 + 0.5 * z / std::sqrt(1.0 + z * z);
}

double sigmoid_slope(double z) {
    const double square = 1.0 + z * z;
    return 0.5 / (square * std::sqrt(square));
}

double band_reflectance(double z) {
    return kDarkestBand + (kLightestBand - kDarkestBand) * sigmoid(z);
}

double inverse_sigmoid(double share) {
    const double centred = 2.0 * share - 1.0;
    return centred / std::sqrt(1.0 - centred * centred);
}

/// White-relative XYZ of a reflectance of 1 in one band alone, a row each for X, Y and Z.
const std::array<std::array<double, kBands>, 3>& bands_to_xyz() {
    static const auto rows = [] {
        std::array<std::array<double, kBands>, 3> product{};
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                for (int k = 0; k < kBands; ++k)
                    product[i][k] += kSrgbToWhiteRelativeXyz[i][j] * kBandsToLinearSrgb[j][k];
            }
        }
        return product;
    }();
    return rows;
}

struct Problem {
    std::array<double, kResiduals> residual{};
    std::array<std::array<double, kBands>, kResiduals> slope{};
    double cost = 0.0;
};

void add_smoothness(const Unknowns& z, Problem& problem) {
    for (int k = 0; k < kSlopes; ++k) {
        const double weight = 1.0 / std::sqrt(kBandCentres_nm[k + 1] - kBandCentres_nm[k]);
        problem.residual[3 + k] = weight * (z[k + 1] - z[k]);
        problem.slope[3 + k][k] = -weight;
        problem.slope[3 + k][k + 1] = weight;
    }
}

void add_colour(const Unknowns& z, const Lab& wanted, double weight, Problem& problem) {
    Xyz colour{};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < kBands; ++k)
            colour[i] += bands_to_xyz()[i][k] * band_reflectance(z[k]);
    }
    const Lab reached = lab(colour, {1.0, 1.0, 1.0});
    problem.residual[0] = weight * (reached.lightness - wanted.lightness);
    problem.residual[1] = weight * (reached.a - wanted.a);
    problem.residual[2] = weight * (reached.b - wanted.b);
    for (int k = 0; k < kBands; ++k) {
        const double step = weight * (kLightestBand - kDarkestBand) * sigmoid_slope(z[k]);
        Xyz curve{};
        for (int i = 0; i < 3; ++i)
            curve[i] = lab_curve_slope(colour[i]) * bands_to_xyz()[i][k] * step;
        problem.slope[0][k] = 116.0 * curve[1];
        problem.slope[1][k] = 500.0 * (curve[0] - curve[1]);
        problem.slope[2][k] = 200.0 * (curve[1] - curve[2]);
    }
}

Problem problem_at(const Unknowns& z, const Lab& wanted, double weight) {
    Problem problem;
    add_colour(z, wanted, weight, problem);
    add_smoothness(z, problem);
    for (const double residual : problem.residual)
        problem.cost += residual * residual;
    return problem;
}

/// Solves the symmetric, positive definite system by Cholesky's factors.
Unknowns solve(Matrix a, Unknowns b) {
    for (int i = 0; i < kBands; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = a[i][j];
            for (int k = 0; k < j; ++k)
                sum -= a[i][k] * a[j][k];
            a[i][j] = i == j ? std::sqrt(std::max(sum, 1e-30)) : sum / a[j][j];
        }
    }
    for (int i = 0; i < kBands; ++i) {
        for (int k = 0; k < i; ++k)
            b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (int i = kBands - 1; i >= 0; --i) {
        for (int k = i + 1; k < kBands; ++k)
            b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
    return b;
}

/// The step of Gauss and Newton from where `problem` stands, held back by `damping`.
Unknowns damped_step(const Problem& problem, double damping) {
    Matrix normal{};
    Unknowns downhill{};
    for (int r = 0; r < kResiduals; ++r) {
        for (int i = 0; i < kBands; ++i) {
            downhill[i] -= problem.slope[r][i] * problem.residual[r];
            for (int j = 0; j <= i; ++j)
                normal[i][j] += problem.slope[r][i] * problem.slope[r][j];
        }
    }
    for (int i = 0; i < kBands; ++i)
        normal[i][i] += damping * (normal[i][i] + 1e-6);
    return solve(normal, downhill);
}

Unknowns moved(const Unknowns& z, const Unknowns& step) {
    Unknowns result{};
    for (int k = 0; k < kBands; ++k)
        result[k] = std::clamp(z[k] + step[k], -kSteepest, kSteepest);
    return result;
}

/// The grey as light as the colour.
Unknowns grey_start(const LinearRgb& colour) {
    const double share = (relative_luminance(colour) - kDarkestBand) / (kLightestBand - kDarkestBand);
    Unknowns z{};
    z.fill(inverse_sigmoid(std::clamp(share, 1e-3, 1.0 - 1e-3)));
    return z;
}

/// Levenberg and Marquardt's iteration for one weight of the colour, from `z` to where it ends.
struct Descent {
    Unknowns& z;
    const Lab& wanted;
    double weight;
    int iterations = 0;

    /// Whether the cost came to rest, its last gain being below `small_gain` of it.
    bool run(int most_iterations, double small_gain) {
        constexpr double kFirstDamping = 1e-4, kLeastDamping = 1e-12, kMostDamping = 1e8;
        constexpr double kRoundings = 1e-12;  // of the cost: no one part of it is larger than 1e-6
        Problem problem = problem_at(z, wanted, weight);
        double damping = kFirstDamping;
        for (iterations = 0; iterations < most_iterations;) {
            if (problem.cost < kRoundings) return true;
            ++iterations;
            const Unknowns tried = moved(z, damped_step(problem, damping));
            const Problem there = problem_at(tried, wanted, weight);
            if (there.cost < problem.cost) {
                const double gain = problem.cost - there.cost;
                z = tried;
                problem = there;
                damping = std::max(0.1 * damping, kLeastDamping);
                if (gain < small_gain * (problem.cost + gain)) return true;
            } else {
                damping *= 10.0;
                if (damping > kMostDamping) return true;
            }
        }
        return false;
    }
};

}  // namespace

SmoothBands smooth_bands(const LinearRgb& colour) {
    // With the full weight at once the descent would creep along a narrow curved valley.
    constexpr std::array<double, 5> kLeadingWeights = {0.3, 1.0, 3.0, 10.0, 30.0};
    constexpr int kLeadingIterations = 6, kLastIterations = 25;
    static_assert(kMostIterations == kLeadingWeights.size() * kLeadingIterations + kLastIterations);
    const Lab wanted = lab(colour);
    Unknowns z = grey_start(colour);
    SmoothBands fit;
    for (const double weight : kLeadingWeights) {
        Descent descent{z, wanted, weight};
        descent.run(kLeadingIterations, 1e-2);
        fit.iterations += descent.iterations;
    }
    Descent last{z, wanted, kColourWeight};
    fit.converged = last.run(kLastIterations, 1e-6);
    fit.iterations += last.iterations;
    for (int k = 0; k < kBands; ++k)
        fit.reflectance[k] = static_cast<float>(band_reflectance(z[k]));
    fit.difference = ciede2000(lab(linear_srgb(fit.reflectance)), wanted);
    return fit;
}

}  // namespace pastoso::pigment
