// Interpolation and advection against exact answers.
#include "liquid/flow/advection.hpp"

#include "core/random.hpp"
#include "liquid/classic/periodic.hpp"
#include "liquid/flow/flow.hpp"
#include "liquid/flow/sampling.hpp"
#include "liquid/flow_cases.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Every sample, ghosts among them, from a function of the place in metres.
template <class Value>
void fill(grid::BoxField& field, Location location, const Value& value) {
    const grid::BoxShape& shape = field.shape();
    for (int k = -2; k <= shape.nz + 2; ++k)
        for (int j = -2; j <= shape.ny + 2; ++j)
            for (int i = -2; i <= shape.nx + 2; ++i)
                field.at(i, j, k) = value((glm::vec3(i, j, k) + offset_cells(location)) * shape.cell_m);
}

TEST(Sampling, LinearIsExactForLinearFieldsAtEveryLocation) {
    const grid::BoxShape shape{7, 5, 6, 0.5F};
    const auto value = [](const glm::vec3& p) { return 1.0F + 2.0F * p.x - 3.0F * p.y + 0.5F * p.z; };
    for (const Location location : {Location::FaceX, Location::FaceY, Location::FaceZ, Location::Cell}) {
        grid::BoxField field(shape);
        fill(field, location, value);
        for (const Interpolation how :
             {Interpolation::Linear, Interpolation::LimitedCubic, Interpolation::Cubic})
            for (const glm::vec3 point :
                 {glm::vec3(0.0F), glm::vec3(1.3F, 0.77F, 2.9F), glm::vec3(3.5F, 2.5F, 3.0F)})
                EXPECT_NEAR(sample(field, location, point, how), value(point), 2e-5F);
    }
}

TEST(Sampling, TheCubicIsExactForSquaresAndTheLimitedOneStaysWithinItsEight) {
    const grid::BoxShape shape{8, 8, 8, 1.0F};
    grid::BoxField square(shape), step(shape);
    fill(square, Location::Cell, [](const glm::vec3& p) { return p.x * p.x - p.y * p.z; });
    fill(step, Location::Cell, [](const glm::vec3& p) { return p.x > 4.0F ? 1.0F : 0.0F; });
    const glm::vec3 point(3.3F, 4.7F, 2.2F);
    // Catmull-Rom reproduces quadratics; rounding of values up to 60.
    EXPECT_NEAR(sample(square, Location::Cell, point, Interpolation::Cubic), 3.3F * 3.3F - 4.7F * 2.2F,
                2e-5F);
    const glm::vec3 beside(4.8F, 4.0F, 4.0F);
    EXPECT_GT(sample(step, Location::Cell, beside, Interpolation::Cubic), 1.01F);
    EXPECT_EQ(sample(step, Location::Cell, beside, Interpolation::LimitedCubic), 1.0F);
}

TEST(Sampling, APointThatIsNoNumberIsPutSomewhereInTheBox) {
    const grid::BoxShape shape{4, 4, 4, 1.0F};
    const grid::BoxField field(shape, 2.0F);
    const float nan = std::nanf("");
    EXPECT_EQ(sample(field, Location::Cell, {nan, nan, nan}, Interpolation::Cubic), 2.0F);
    EXPECT_EQ(sample(field, Location::Cell, {1e30F, -1e30F, 0.0F}, Interpolation::Linear), 2.0F);
}

/// Carries cells along a velocity in a periodic box.
class PeriodicCells {
  public:
    explicit PeriodicCells(const grid::BoxShape& shape,
                           Interpolation interpolation = Interpolation::LimitedCubic)
        : velocity(shape),
          interpolation_(interpolation),
          advection_(shape, whole(shape), Edges::Periodic),
          next_(shape) {}

    void advect(grid::BoxField& field, float dt_s, core::ThreadPool& pool) {
        fill_periodic_ghosts(field, pool);
        advection_.follow(velocity, pool);
        const AdvectedPair pair = {&field, &next_};
        advection_.advect({&pair, 1}, Location::Cell, dt_s, interpolation_, pool);
        std::swap(field, next_);
        fill_periodic_ghosts(field, pool);
    }

    VelocityField velocity;

  private:
    static std::array<RowRanges, 4> whole(const grid::BoxShape& shape) {
        const RowRanges cells = RowRanges::whole(shape, Location::Cell);
        return {cells, cells, cells, cells};
    }

    Interpolation interpolation_;
    Advection advection_;
    grid::BoxField next_;
};

TEST(Advection, AUniformFlowShiftsAPeriodicPatternExactly) {
    // One cell a step: the way back ends on samples, where every interpolation is exact.
    core::ThreadPool pool(2);
    const grid::BoxShape shape{16, 12, 8, 0.25F};
    PeriodicCells flow(shape);
    for (const int axis : kAxes)
        flow.velocity.along(axis) = grid::BoxField(shape, axis == 0 ? 0.5F : axis == 1 ? -0.25F : 0.0F);
    grid::BoxField field(shape);
    cases::fill_randomly(field, 4);
    fill_periodic_ghosts(field, pool);
    const grid::BoxField before = field;
    for (int step = 0; step < 3; ++step)
        flow.advect(field, 1.0F, pool);
    for (int k = 0; k < 8; ++k)
        for (int j = 0; j < 12; ++j)
            for (int i = 0; i < 16; ++i)
                ASSERT_EQ(field.at(i, j, k), before.at((i + 16 - 6) % 16, (j + 3) % 12, k));
}

/// Error of a sine carried through a third of a periodic box by a uniform flow that is not along an
/// axis.
double sine_error(int cells, Interpolation interpolation) {
    core::ThreadPool pool(2);
    const grid::BoxShape shape{cells, cells, 4, 1.0F / static_cast<float>(cells)};
    PeriodicCells flow(shape, interpolation);
    flow.velocity.x = grid::BoxField(shape, 1.0F);
    flow.velocity.y = grid::BoxField(shape, 0.7F);
    grid::BoxField field(shape);
    const auto value = [](const glm::vec3& p) {
        return std::sin(2.0F * kPi * p.x) * std::cos(2.0F * kPi * p.y);
    };
    fill(field, Location::Cell, value);
    // Steps of 0.45 cells, so that the error is the interpolation's alone.
    const int steps = cells / 3;
    const float dt_s = 0.45F * shape.cell_m;
    for (int step = 0; step < steps; ++step)
        flow.advect(field, dt_s, pool);
    const glm::vec3 moved = glm::vec3(1.0F, 0.7F, 0.0F) * (dt_s * static_cast<float>(steps));
    double sum = 0.0;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const glm::vec3 at = (glm::vec3(i, j, 0) + 0.5F) * shape.cell_m - moved;
            sum += std::abs(static_cast<double>(field.at(i, j, 1) - value(at)));
        }
    return sum / (cells * cells);
}

TEST(Advection, HasTheOrderOfItsInterpolation) {
    // A fixed share of a cell a step: one order less than the interpolation's own, which is 2 and 4
    // (Catmull-Rom: 3 in general; at a fixed phase its leading error is of fourth order in amplitude).
    const double linear =
        std::log2(sine_error(32, Interpolation::Linear) / sine_error(64, Interpolation::Linear));
    EXPECT_GT(linear, 0.85);
    EXPECT_LT(linear, 1.2);
    const double cubic =
        std::log2(sine_error(32, Interpolation::Cubic) / sine_error(64, Interpolation::Cubic));
    EXPECT_GT(cubic, 1.9);
    // The clamp flattens crests: it stays well ahead of the linear one.
    EXPECT_LT(sine_error(64, Interpolation::LimitedCubic), 0.1 * sine_error(64, Interpolation::Linear));
}

struct Turned {
    double error;  ///< sum of |difference| over the sphere's volume
    double mass;   ///< change of the sum
    float largest;
};
/// One turn of a slotted sphere about the box's upright axis.
Turned turn_slotted_sphere(int cells, Interpolation interpolation) {
    core::ThreadPool pool(2);
    const grid::BoxShape shape{cells, cells, cells, 1.0F / static_cast<float>(cells)};
    PeriodicCells flow(shape, interpolation);
    fill(flow.velocity.x, Location::FaceX, [](const glm::vec3& p) { return 0.5F - p.y; });
    fill(flow.velocity.y, Location::FaceY, [](const glm::vec3& p) { return p.x - 0.5F; });
    grid::BoxField field(shape);
    fill(field, Location::Cell, [](const glm::vec3& p) {
        const glm::vec3 r = p - glm::vec3(0.5F, 0.75F, 0.5F);
        const bool slot = std::abs(r.x) < 0.03F && r.y < 0.08F;
        return r.x * r.x + r.y * r.y + r.z * r.z < 0.15F * 0.15F && !slot ? 1.0F : 0.0F;
    });
    const grid::BoxField before = field;
    const int steps = cells * 158 / 64;
    for (int step = 0; step < steps; ++step)
        flow.advect(field, 2.0F * kPi / static_cast<float>(steps), pool);
    Turned turned{};
    double sum_before = 0.0, sum_after = 0.0;
    for (int k = 0; k < cells; ++k)
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                turned.error += static_cast<double>(std::abs(field.at(i, j, k) - before.at(i, j, k)));
                sum_before += static_cast<double>(before.at(i, j, k));
                sum_after += static_cast<double>(field.at(i, j, k));
                turned.largest = std::max(turned.largest, field.at(i, j, k));
            }
    turned.error /= sum_before;
    turned.mass = sum_after / sum_before - 1.0;
    return turned;
}

TEST(Advection, TurnsASlottedSphere) {
    const Turned limited = turn_slotted_sphere(64, Interpolation::LimitedCubic);
    EXPECT_LT(limited.error, 0.75);
    EXPECT_LE(limited.largest, 1.0F);
    EXPECT_LT(std::abs(limited.mass), 0.08);
    // The cubic as it is keeps the sum and overshoots.
    const Turned cubic = turn_slotted_sphere(64, Interpolation::Cubic);
    EXPECT_LT(cubic.error, limited.error);
    EXPECT_LT(std::abs(cubic.mass), 2e-3);
    EXPECT_GT(cubic.largest, 1.05F);
}

/// Every sample by lot, ghosts among them.
void fill_by_lot(grid::BoxField& field, std::uint32_t stream) {
    for (std::uint32_t n = 0; n < field.values().size(); ++n)
        field.values()[n] = core::uniform_noise(n, stream);
}

TEST(Advection, AGroupOfSamplesIsWhatEachIsByItself) {
    core::ThreadPool pool(1);
    const grid::BoxShape shape{11, 5, 4, 1.0F};
    VelocityField velocity(shape);
    grid::BoxField field(shape), advected(shape);
    fill_by_lot(field, 1);
    std::array<RowRanges, 4> rows;
    for (const Location location : {Location::FaceX, Location::FaceY, Location::FaceZ, Location::Cell})
        rows[static_cast<std::size_t>(location)] = RowRanges::whole(shape, location);
    // Exact in floats, into all corners of the box and out of it.
    for (const glm::vec3 way : {glm::vec3(0.75F, -1.25F, 0.5F), glm::vec3(-2.25F, 3.5F, -0.125F),
                                glm::vec3(9.0F, 9.0F, 9.0F), glm::vec3(-9.0F, -9.0F, -9.0F)}) {
        for (const int axis : kAxes)
            velocity.along(axis) = grid::BoxField(shape, way[axis]);
        for (const WaysOf ways_of : {WaysOf::Samples, WaysOf::Cells}) {
            Advection advection(shape, rows, Edges::Walls, core::kernels<Kernels>(), ways_of);
            advection.follow(velocity, pool);
            for (const Location location :
                 {Location::FaceX, Location::FaceY, Location::FaceZ, Location::Cell})
                for (const Interpolation how :
                     {Interpolation::Linear, Interpolation::LimitedCubic, Interpolation::Cubic}) {
                    const AdvectedPair pair = {&field, &advected};
                    advection.advect({&pair, 1}, location, 1.0F, how, pool);
                    const auto counts = sample_counts(shape, location);
                    for (int k = 0; k < counts[2]; ++k)
                        for (int j = 0; j < counts[1]; ++j)
                            for (int i = 0; i < counts[0]; ++i)
                                ASSERT_EQ(
                                    advected.at(i, j, k),
                                    sample(field, location,
                                           glm::vec3(i, j, k) + offset_cells(location) - way, how));
                }
        }
    }
}

TEST(Advection, PointsOfAGroupMoveAsEachByItself) {
    const grid::BoxShape shape{9, 7, 8, 0.5F};
    VelocityField velocity(shape);
    for (const int axis : kAxes)
        fill_by_lot(velocity.along(axis), static_cast<std::uint32_t>(axis));
    std::vector<glm::vec3> together;
    for (std::uint32_t n = 0; n < 500; ++n)
        together.emplace_back(4.5F * core::uniform_noise(n, 5), 3.5F * core::uniform_noise(n, 6),
                              4.0F * core::uniform_noise(n, 7));
    std::vector<glm::vec3> alone = together;
    carry_points(together, velocity, 0.3F, Edges::Walls, Interpolation::Cubic);
    for (glm::vec3& point : alone)
        carry_points({&point, 1}, velocity, 0.3F, Edges::Walls, Interpolation::Cubic);
    EXPECT_EQ(together, alone);
}

TEST(Advection, PointsGoRoundACircle) {
    core::ThreadPool pool(2);
    const grid::BoxShape shape{32, 32, 8, 1.0F / 32.0F};
    VelocityField velocity(shape);
    fill(velocity.x, Location::FaceX, [](const glm::vec3& p) { return 0.5F - p.y; });
    fill(velocity.y, Location::FaceY, [](const glm::vec3& p) { return p.x - 0.5F; });
    const auto distance_after_a_turn = [&](int steps) {
        std::vector<glm::vec3> points = {{0.8F, 0.5F, 0.1F}, {0.5F, 0.3F, 0.2F}};
        for (int step = 0; step < steps; ++step)
            carry_points(points, velocity, 2.0F * kPi / static_cast<float>(steps), Edges::Walls,
                         Interpolation::Cubic, pool);
        return glm::length(points[0] - glm::vec3(0.8F, 0.5F, 0.1F));
    };
    // The midpoint rule: second order in the step.
    const float coarse = distance_after_a_turn(40), fine = distance_after_a_turn(80);
    EXPECT_LT(coarse, 0.01F);
    EXPECT_NEAR(coarse / fine, 4.0F, 0.4F);
}

TEST(Advection, PointsStayInTheBox) {
    core::ThreadPool pool(1);
    const grid::BoxShape shape{8, 8, 8, 0.125F};
    VelocityField velocity(shape);
    velocity.x = grid::BoxField(shape, 1.0F);
    std::vector<glm::vec3> points = {{0.9F, 0.5F, 0.5F}, {std::nanf(""), 0.5F, 0.5F}};
    carry_points(points, velocity, 0.5F, Edges::Walls, Interpolation::Cubic, pool);
    EXPECT_EQ(points[0], glm::vec3(1.0F, 0.5F, 0.5F));
    EXPECT_TRUE(std::isfinite(points[1].x));
    points[0] = {0.9F, 0.5F, 0.5F};
    carry_points(points, velocity, 0.5F, Edges::Periodic, Interpolation::Cubic, pool);
    EXPECT_NEAR(points[0].x, 0.4F, 1e-6F);
}

}  // namespace
}  // namespace pastoso::liquid
