// The pressure's solver on vessels, boxes and odd shapes.
#include "liquid/pressure/pressure.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "liquid/flow_cases.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

/// ||source - A solution|| / ||source|| over the cells that take part, in double precision.
double true_residual(const CellMatrix& matrix, const grid::BoxField& source,
                     const grid::BoxField& solution) {
    const grid::BoxShape& shape = matrix.shape();
    double remaining = 0.0, whole = 0.0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const double own = static_cast<double>(matrix.diagonal(i, j, k));
                if (!(own > 0.0)) continue;
                double image = own * static_cast<double>(solution.at(i, j, k));
                for (const int axis : kAxes) {
                    const grid::BoxField& a = matrix.faces.along(axis);
                    const std::ptrdiff_t at = shape.index(i, j, k), step = stride(shape, axis);
                    const auto value = [](const grid::BoxField& field, std::ptrdiff_t index) {
                        return static_cast<double>(field.values()[static_cast<std::size_t>(index)]);
                    };
                    image -= value(a, at) * value(solution, at - step) +
                             value(a, at + step) * value(solution, at + step);
                }
                const double b = static_cast<double>(source.at(i, j, k));
                remaining += (b - image) * (b - image);
                whole += b * b;
            }
    return std::sqrt(remaining / whole);
}

struct Vessel {
    const char* name;
    SignedDistance distance;
};

int iterations(const Vessel& vessel, int cells, float tolerance, core::ThreadPool& pool) {
    const Walls walls(cases::cup_box(cells), vessel.distance);
    VelocityField velocity = cases::random_velocity(walls.shape(), 3);
    const float before = largest_divergence(walls, velocity, pool);
    Projection projection(walls);
    const SolveResult result = projection.project(walls, velocity, {tolerance, 50}, pool);
    EXPECT_TRUE(result.converged) << vessel.name << ", " << cells << " cells";
    // The specification's figures: the largest cell against the root-sum-square that the solver bounds.
    const float allowed = tolerance == 1e-6F ? 5e-6F : 2.0F * tolerance;
    EXPECT_LT(largest_divergence(walls, velocity, pool), allowed * before)
        << vessel.name << ", " << cells;
    return result.iterations;
}

/// One sweep down and up of a level on random sources; how many cells of a colour stood in plain rows.
int sweep(const Kernels& kernels, bool plain, ColourField& value, ColourField& coarse_source) {
    const grid::BoxShape shape = {70, 12, 12, 0.01F};
    CellMatrix matrix = pressure_matrix(Walls(shape, cases::no_walls));
    matrix.faces.x.at(60, 5, 5) = 0.25F;
    MultigridLevels levels(shape);
    core::ThreadPool pool(1);
    levels.set_matrix(matrix, RowRanges::whole(shape, Location::Cell), pool);
    MultigridLevel &level = levels.levels()[0], &coarse = levels.levels()[1];
    grid::BoxField source(shape);
    cases::fill_randomly(source, 17);
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                level.source.at(i, j, k) = source.at(i, j, k);
    int plain_cells = 0;
    for (GroupRange& row : level.rows) {
        if (!plain) row.plain_begin = row.plain_end = row.begin;
        plain_cells += row.plain_end - row.plain_begin;
    }
    const LevelView fine_view = level.view(), coarse_view = coarse.view();
    for (int k = 0; k < shape.nz; ++k)
        kernels.relax_from_zero(fine_view, k);
    for (const int colour : {1, 0, 1})
        for (int k = 0; k < shape.nz; ++k)
            kernels.relax(fine_view, colour, k);
    for (int k = 0; k < coarse.extent.nz; ++k)
        kernels.restrict_residual(fine_view, coarse_view, k);
    value = level.value;
    coarse_source = coarse.source;
    return plain_cells;
}

TEST(Multigrid, PlainRowsGiveTheBitsThatTheirCoefficientsGive) {
    for (const Kernels* table :
         {&core::kernels<Kernels>(core::Isa::Baseline), &core::kernels<Kernels>()}) {
        ColourField value, coarse_source, expected, expected_coarse;
        // Inner rows hold four groups of which the first has the wall; a face in row (5, 5) is no plain
        // one, nor are the twelve rows around the box.
        EXPECT_GT(sweep(*table, true, value, coarse_source), 16 * 90);
        EXPECT_EQ(sweep(*table, false, expected, expected_coarse), 0);
        for (int k = 0; k < 12; ++k)
            for (int j = 0; j < 12; ++j)
                for (int i = 0; i < 70; ++i) {
                    ASSERT_EQ(value.at(i, j, k), expected.at(i, j, k)) << i << ' ' << j << ' ' << k;
                    ASSERT_EQ(coarse_source.at(i / 2, j / 2, k / 2),
                              expected_coarse.at(i / 2, j / 2, k / 2));
                }
    }
}

/// Random positive coefficients between the cells of a block of a box, whose other cells take no part.
CellMatrix block_matrix(const grid::BoxShape& shape, const glm::ivec3& low, const glm::ivec3& high,
                        RowRanges& rows) {
    CellMatrix matrix(shape);
    rows = RowRanges(shape);
    for (int k = low.z; k < high.z; ++k)
        for (int j = low.y; j < high.y; ++j)
            for (int i = low.x; i < high.x; ++i) {
                const auto at = static_cast<std::uint32_t>(shape.index(i, j, k));
                rows.include(i, j, k);
                if (i > low.x) matrix.faces.x.at(i, j, k) = 0.1F + core::uniform_noise(at, 1);
                if (j > low.y) matrix.faces.y.at(i, j, k) = 0.1F + core::uniform_noise(at, 2);
                if (k > low.z) matrix.faces.z.at(i, j, k) = 0.1F + core::uniform_noise(at, 3);
                if (k == high.z - 1) matrix.boundary.at(i, j, k) = 2.0F;
            }
    return matrix;
}

TEST(Multigrid, OneMatrixAfterTheOtherIsAsGoodAsANewSolver) {
    const grid::BoxShape shape = {33, 20, 18, 0.01F};
    core::ThreadPool pool(2);
    ConjugateGradients used(shape);
    grid::BoxField source(shape);
    cases::fill_randomly(source, 5);
    const std::pair<glm::ivec3, glm::ivec3> blocks[] = {
        {{0, 0, 0}, {33, 20, 18}}, {{3, 2, 1}, {20, 9, 12}}, {{14, 5, 6}, {33, 20, 17}}};
    for (const auto& [low, high] : blocks) {
        RowRanges rows;
        const CellMatrix matrix = block_matrix(shape, low, high, rows);
        used.set_matrix(matrix, rows, pool);
        ConjugateGradients fresh(matrix);
        grid::BoxField solution(shape), expected(shape);
        const SolveResult result = used.solve(source, solution, {1e-5F, 50}, pool);
        EXPECT_EQ(result, fresh.solve(source, expected, {1e-5F, 50}, pool));
        EXPECT_TRUE(result.converged);
        EXPECT_EQ(solution, expected);
    }
}

TEST(Pressure, FreesACupAndABoxOfDivergenceInFewIterations) {
    core::ThreadPool pool(2);
    for (const Vessel& vessel : {Vessel{"cup", cases::cup_distance()}, Vessel{"box", cases::no_walls}}) {
        const int coarse = iterations(vessel, 64, 1e-6F, pool);
        const int fine = iterations(vessel, 128, 1e-6F, pool);
        EXPECT_LE(coarse, 14) << vessel.name;
        EXPECT_LE(fine, coarse + 3) << vessel.name;
        RecordProperty(vessel.name, coarse);
        EXPECT_LE(iterations(vessel, 64, 1e-3F, pool), 7) << vessel.name;
        EXPECT_LE(iterations(vessel, 64, 1e-4F, pool), 9) << vessel.name;
    }
}

TEST(Pressure, TheResidualItReportsIsTheTrueOne) {
    core::ThreadPool pool(2);
    const Walls walls(cases::cup_box(32), cases::cup_distance());
    const CellMatrix matrix = pressure_matrix(walls);
    VelocityField velocity = cases::random_velocity(walls.shape(), 5);
    grid::BoxField source(walls.shape()), solution(walls.shape());
    for (int k = 0; k < 32; ++k)
        for (int j = 0; j < 32; ++j)
            for (int i = 0; i < 32; ++i) {
                const auto& w = walls.open();
                source.at(i, j, k) = w.x.at(i, j, k) * velocity.x.at(i, j, k) -
                                     w.x.at(i + 1, j, k) * velocity.x.at(i + 1, j, k);
            }
    for (const float tolerance : {1e-3F, 1e-5F}) {
        const SolveResult result =
            ConjugateGradients(matrix).solve(source, solution, {tolerance, 50}, pool);
        EXPECT_TRUE(result.converged);
        // The recurrence of the residual drifts by rounding alone: some 1e-7 an iteration.
        EXPECT_NEAR(true_residual(matrix, source, solution), result.residual, 2e-6);
    }
}

TEST(Pressure, AWarmStartNeedsNoIteration) {
    core::ThreadPool pool(1);
    const Walls walls(cases::cup_box(32), cases::cup_distance());
    const VelocityField velocity = cases::random_velocity(walls.shape(), 7);
    Projection projection(walls);
    VelocityField first = velocity, second = velocity;
    EXPECT_GT(projection.project(walls, first, {1e-4F, 50}, pool).iterations, 3);
    EXPECT_EQ(projection.project(walls, second, {1.1e-4F, 50}, pool).iterations, 0);
    projection.start_cold();
    EXPECT_GT(projection.project(walls, second = velocity, {1e-4F, 50}, pool).iterations, 3);
}

TEST(Pressure, TheLimitOfIterationsIsReported) {
    core::ThreadPool pool(1);
    const Walls walls(cases::cup_box(32), cases::cup_distance());
    VelocityField velocity = cases::random_velocity(walls.shape(), 7);
    const SolveResult result = Projection(walls).project(walls, velocity, {1e-6F, 2}, pool);
    EXPECT_EQ(result.iterations, 2);
    EXPECT_FALSE(result.converged);
    EXPECT_GT(result.residual, 1e-6F);
}

/// Two rooms side by side.
float two_rooms(const glm::vec3& point_m) {
    const glm::vec3 cell = point_m / (0.1F / 16.0F);
    if (std::abs(cell.x - 8.0F) < 1.0F) return 1.0F;
    return -1.0F;
}

TEST(Pressure, EachClosedRoomLosesItsOwnMean) {
    core::ThreadPool pool(1);
    const Walls walls({16, 16, 16, 0.1F / 16.0F}, two_rooms);
    const CellMatrix matrix = pressure_matrix(walls);
    grid::BoxField source(walls.shape()), solution(walls.shape());
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
                source.at(i, j, k) = (i < 8 ? 5.0F : -2.0F) + 0.1F * static_cast<float>((i * j + k) % 7);
    const SolveResult result = ConjugateGradients(matrix).solve(source, solution, {1e-5F, 50}, pool);
    EXPECT_TRUE(result.converged) << result.residual;
    EXPECT_LE(result.iterations, 14);
    double left = 0.0, right = 0.0;
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
                (i < 8 ? left : right) += static_cast<double>(solution.at(i, j, k));
    // Means of floats of size 1 over 2048 cells.
    EXPECT_NEAR(left / 2048.0, 0.0, 1e-6);
    EXPECT_NEAR(right / 2048.0, 0.0, 1e-6);
}

TEST(Pressure, AnOpenCellApartFromAClosedVesselDoesNotHideItsNullSpace) {
    // One cell with a given boundary only: the rest stays a closed system.
    core::ThreadPool pool(1);
    const grid::BoxShape shape{16, 16, 16, 1.0F};
    CellMatrix matrix(shape);
    for (int k = 0; k < 16; ++k)
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 12; ++i) {
                if (i > 0) matrix.faces.x.at(i, j, k) = 1.0F;
                if (j > 0) matrix.faces.y.at(i, j, k) = 1.0F;
                if (k > 0) matrix.faces.z.at(i, j, k) = 1.0F;
            }
    matrix.boundary.at(14, 7, 7) = 2.0F;
    grid::BoxField source(shape), solution(shape);
    cases::fill_randomly(source, 9);
    source.at(14, 7, 7) = 3.0F;
    const SolveResult result = ConjugateGradients(matrix).solve(source, solution, {1e-5F, 50}, pool);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.iterations, 14);
    EXPECT_NEAR(solution.at(14, 7, 7), 1.5F, 1e-5F);
}

TEST(Pressure, AirAboveTheFluidIsABoundary) {
    // Fluid below, given pressure 0 half a cell above it: p grows linearly with depth.
    core::ThreadPool pool(1);
    const grid::BoxShape shape{24, 20, 32, 1.0F};
    CellMatrix matrix(shape);
    constexpr int kLevel = 19;
    grid::BoxField source(shape), solution(shape);
    for (int k = 0; k < kLevel; ++k)
        for (int j = 0; j < 20; ++j)
            for (int i = 0; i < 24; ++i) {
                if (i > 0) matrix.faces.x.at(i, j, k) = 1.0F;
                if (j > 0) matrix.faces.y.at(i, j, k) = 1.0F;
                if (k > 0) matrix.faces.z.at(i, j, k) = 1.0F;
                if (k == kLevel - 1) {
                    matrix.boundary.at(i, j, k) = 2.0F;
                    // The outflow that a unit fall through every face leaves here alone.
                    source.at(i, j, k) = 1.0F;
                }
                if (k == 0) source.at(i, j, k) += 1.0F;
                if (k == kLevel - 1) source.at(i, j, k) -= 1.0F;
            }
    const SolveResult result = ConjugateGradients(matrix).solve(source, solution, {1e-6F, 50}, pool);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.iterations, 14);
    // A residual of 1e-6 may hide that times the system's condition, some thousands.
    for (const int k : {0, 7, kLevel - 1})
        EXPECT_NEAR(solution.at(5, 6, k), 0.5F + static_cast<float>(kLevel - 1 - k), 1e-3F) << k;
}

TEST(Pressure, RefusesLimitsThatMeanNothing) {
    EXPECT_THROW(check(SolveLimits{0.0F, 50}), core::InputError);
    EXPECT_THROW(check(SolveLimits{std::nanf(""), 50}), core::InputError);
    EXPECT_THROW(check(SolveLimits{1e-3F, 0}), core::InputError);
}

}  // namespace
}  // namespace pastoso::liquid
