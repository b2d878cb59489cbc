// Thixotropic paint (film/cell/structure.hpp): the laws of Moore and Houska on a sheared film, rest, and
// what the solver carries.
#include "core/isa.hpp"
#include "film/explicit/tile_step.hpp"
#include "film/film_bench.hpp"
#include "film/random_paint.hpp"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

constexpr double kThickness_mm = 1.3, kForce = 6.0, kViscosity = 2.0;

Scene thixotropic(double force) {
    return {.width = 8,
            .height = 8,
            .cell_mm = 8,  // far from the speed clamp, half a cell a step
            .force_x = force,
            .viscosity = kViscosity,
            .structure_share = 0.6,
            .recovery_s = 4.0,
            .breakdown_strain = 3.0};
}

/// The worked share of a cell's paint, 1 - lambda.
double worked_share(const Bench& bench, int x, int y) {
    return static_cast<double>(bench.state.worked.thickness.at(x, y)) / bench.state.thickness.at(x, y);
}

void work_all(Bench& bench) {
    for (int y = 0; y < bench.setup.height; ++y)
        for (int x = 0; x < bench.setup.width; ++x)
            bench.state.worked.thickness.set(x, y, bench.state.thickness.at(x, y));
}

/// A film of Newtonian paint under a force along it: u its mean speed, w = 1 - lambda.
struct Flow {
    double u = 0.0, w = 0.0;
};

/// du/dt = F - 3 nu (1 - theta w) u / h^2,  dw/dt = (1 - w) 1.5 u / (h gamma_b) - w / T,
/// 1.5 u / h the mean shear of a parabola.
Flow change(const Scene& scene, const Flow& now) {
    const double viscosity = scene.viscosity * (1.0 - scene.structure_share * now.w);
    const double drag = 3.0 * viscosity / (kThickness_mm * kThickness_mm);
    const double shear_per_s = 1.5 * now.u / kThickness_mm;
    return {scene.force_x - drag * now.u,
            (1.0 - now.w) * shear_per_s / scene.breakdown_strain - now.w / scene.recovery_s};
}

Flow exact_flow(const Scene& scene, double seconds) {
    constexpr int kSteps = 20000;
    const double dt = seconds / kSteps;
    Flow flow;
    for (int i = 0; i < kSteps; ++i) {
        const Flow first = change(scene, flow);
        const Flow middle = change(scene, {flow.u + 0.5 * dt * first.u, flow.w + 0.5 * dt * first.w});
        flow.u += dt * middle.u;
        flow.w += dt * middle.w;
    }
    return flow;
}

struct Errors {
    double u, w;
};

/// How far off the film is after two seconds, while it loosens.
Errors errors_in_steps_of(double dt_s, film::Scheme scheme) {
    Scene scene = thixotropic(kForce);
    scene.solver.scheme = scheme;
    Bench bench(scene);
    bench.fill([](int, int) { return kThickness_mm; });
    bench.carry_consistency();
    bench.run(dt_s, 2.0);
    const Flow exact = exact_flow(scene, 2.0);
    EXPECT_GT(exact.w, 0.5);
    EXPECT_LT(exact.w, 0.8);
    return {std::abs(bench.u(3, 4) - exact.u) / exact.u, std::abs(worked_share(bench, 3, 4) - exact.w)};
}

class StructureOfEveryScheme : public testing::TestWithParam<film::Scheme> {};

TEST_P(StructureOfEveryScheme, FollowsTheLawOfASheet) {
    const Errors coarse = errors_in_steps_of(0.04, GetParam());
    const Errors fine = errors_in_steps_of(0.01, GetParam());
    EXPECT_LT(fine.u, 0.01);
    EXPECT_LT(fine.w, 0.005);
    // Structure and flow in turn are of the first order: a quarter of the step, a quarter of the error.
    EXPECT_NEAR(coarse.w / fine.w, 4.0, 0.8);
}

INSTANTIATE_TEST_SUITE_P(Schemes, StructureOfEveryScheme,
                         testing::Values(film::Scheme::Explicit, film::Scheme::LargeStep),
                         [](const auto& test) {
                             return test.param == film::Scheme::Explicit ? "Explicit" : "LargeStep";
                         });

/// Where paint loosens as fast as it stiffens, lambda / (1 - lambda) = gamma_b / (gamma' T).
TEST(Structure, ComesToItsEquilibrium) {
    Bench bench(thixotropic(kForce));
    bench.fill([](int, int) { return kThickness_mm; });
    bench.carry_consistency();
    bench.run(0.02, 40.0);
    const double shear_per_s = 1.5 * bench.u(3, 4) / kThickness_mm;
    const double strains = shear_per_s * bench.setup.recovery_s / bench.setup.breakdown_strain;
    EXPECT_NEAR(worked_share(bench, 3, 4), strains / (1.0 + strains), 0.003);
}

TEST(Structure, ComesBackAtRestAndIsForgotten) {
    Bench bench(thixotropic(0.0));
    bench.fill([](int x, int) { return x < 4 ? 1.0 : 0.3; });
    bench.carry_consistency();
    work_all(bench);
    for (int second = 1; second <= 5; ++second) {
        bench.run(0.1, 1.0);
        for (const int x : {1, 6})
            EXPECT_NEAR(worked_share(bench, x, 3), std::exp(-second / bench.setup.recovery_s), 1e-4);
    }
    bench.run(0.1, 40.0);
    EXPECT_FALSE(bench.state.worked.is_anywhere());
}

/// Its yield stress holds it, but for a time after it was worked.
TEST(Structure, RunsWhenItIsWorkedAndStandsAgain) {
    Scene scene = thixotropic(kForce);
    scene.yield = 1.2 * kForce * kThickness_mm;
    scene.breakdown_strain = 1000.0;  // what flows does not loosen itself
    Bench rested(scene), worked(scene);
    for (Bench* bench : {&rested, &worked}) {
        bench->fill([](int, int) { return kThickness_mm; });
        bench->carry_consistency();
    }
    work_all(worked);
    rested.run(0.02, 1.0);
    worked.run(0.02, 1.0);
    EXPECT_EQ(rested.u(3, 4), 0.0);
    EXPECT_GT(worked.u(3, 4), 0.5);
    // 1 - theta e^(-t/T) of the yield stress is more than the force at t = T ln(1.2 theta / 0.2) = 5.1
    // s.
    worked.run(0.02, 3.5);
    EXPECT_GT(worked.u(3, 4), 0.0);
    worked.run(0.02, 3.0);
    EXPECT_EQ(worked.u(3, 4), 0.0);
}

TEST(Structure, OfAMediumWithoutItIsNotFollowed) {
    Scene scene = thixotropic(kForce);
    scene.structure_share = 0.0;
    Bench bench(scene);
    bench.fill([](int, int) { return kThickness_mm; });
    bench.run(0.02, 1.0);
    EXPECT_FALSE(bench.state.worked.is_followed);
    EXPECT_FALSE(bench.state.worked.is_anywhere());
}

/// Drops that run down aslant over four tiles.
Scene drops(film::Scheme scheme, int threads = 1) {
    Scene scene = runny(150, 100);
    scene.structure_share = 0.7;
    scene.recovery_s = 5.0;
    scene.breakdown_strain = 2.0;
    scene.threads = threads;
    scene.solver.scheme = scheme;
    return scene;
}

void lay_drops(Bench& bench, bool mirrored = false) {
    const auto place = [&](int x) { return mirrored ? bench.setup.width - 1 - x : x; };
    bench.fill([&](int x, int y) {
        return blob(place(x), y, 70, 60, 18, 3.5) + blob(place(x), y, 20, 50, 9, 1);
    });
    bench.carry_consistency();
    bench.tint(2, [&](int x, int y) { return place(x) + y; });
}

double step_of(film::Scheme scheme) {
    return scheme == film::Scheme::Explicit ? 0.04 : 1.0;
}

/// Bit for bit in explicit steps; large ones sweep their patches from left to right.
TEST(Structure, IsMirroredWithItsPaint) {
    Scene scene = drops(film::Scheme::Explicit), mirror = scene;
    mirror.force_x = -scene.force_x;
    Bench bench(scene), mirrored(mirror);
    lay_drops(bench);
    lay_drops(mirrored, true);
    bench.run(0.04, 12.0);
    mirrored.run(0.04, 12.0);
    ASSERT_TRUE(bench.state.worked.is_anywhere());
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            const int other = scene.width - 1 - x;
            ASSERT_EQ(bench.state.thickness.at(x, y), mirrored.state.thickness.at(other, y));
            ASSERT_EQ(bench.state.worked.thickness.at(x, y),
                      mirrored.state.worked.thickness.at(other, y))
                << x << ", " << y;
        }
}

TEST_P(StructureOfEveryScheme, IsTheSameOnAnyNumberOfThreads) {
    const auto hash = [&](int threads) {
        Bench bench(drops(GetParam(), threads));
        lay_drops(bench);
        bench.run(step_of(GetParam()), 8.0);
        return state_hash(bench.state);
    };
    const std::uint64_t reference = hash(1);
    EXPECT_EQ(hash(2), reference);
    EXPECT_EQ(hash(3), reference);
}

TEST_P(StructureOfEveryScheme, LosesNoPaintAndIsAlwaysAPartOfIt) {
    for (const EdgeKind edges : {EdgeKind::Periodic, EdgeKind::Wall, EdgeKind::Open, EdgeKind::Mixed})
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            RandomPaint paint = random_paint(seed, edges);
            paint.scene.structure_share = 0.8;
            paint.scene.breakdown_strain = 0.5;
            paint.scene.solver.scheme = GetParam();
            Bench bench(paint.scene);
            bench.fill(paint.thickness);
            bench.set_support(paint.support);
            bench.carry_consistency();
            bench.tint(3, [](int x, int y) { return (x * 7 + y * 3) % 40; });
            const Totals before = totals(bench.state);
            for (int step = 0; step < 40; ++step)
                bench.solver->advance(0.01);
            const Totals after = totals(bench.state), runoff = bench.solver->runoff();
            EXPECT_EQ(after.thickness + runoff.thickness, before.thickness);
            EXPECT_EQ(after.paint[3] + runoff.paint[3], before.paint[3]) << name_of(edges) << seed;
            for (int y = 0; y < bench.setup.height; ++y)
                for (int x = 0; x < bench.setup.width; ++x) {
                    const std::int32_t worked = bench.state.worked.thickness.at(x, y);
                    ASSERT_GE(worked, 0);
                    ASSERT_LE(worked, bench.state.thickness.at(x, y)) << name_of(edges) << seed;
                }
        }
}

/// Random paint, worked here and there, and random fluxes that no cell is overdrawn by.
struct KernelInput {
    explicit KernelInput(std::uint32_t seed) {
        std::mt19937 random(seed);
        std::uniform_int_distribution<std::int32_t> thickness(0, kMaxThickness_quanta / 4);
        std::uniform_real_distribution<float> share(0.0F, 1.0F);
        for (int i = 0; i < kBlockCells; ++i) {
            scratch->block.quanta[i] = share(random) < 0.2F ? 0 : thickness(random);
            worked[i] =
                static_cast<std::int32_t>(share(random) * static_cast<float>(scratch->block.quanta[i]));
        }
        fill_fluxes(random, 1, scratch->flux_x);
        fill_fluxes(random, kBlockStride, scratch->flux_y);
        core::kernels<TileKernels>(core::Isa::Baseline).apply_fluxes(*scratch, after.data());
    }

    void fill_fluxes(std::mt19937& random, int along, FaceArray<std::int32_t>& flux) {
        std::uniform_real_distribution<float> share(-0.25F, 0.25F);
        flux.fill(0);
        for (int y = -1; y < grid::kTileSize; ++y)
            for (int x = -1; x < grid::kTileSize; ++x) {
                const float s = share(random);
                const int cell = block_index(x, y);
                const std::int32_t donor = scratch->block.quanta[s > 0.0F ? cell : cell + along];
                flux[face_index(x, y)] = static_cast<std::int32_t>(s * static_cast<float>(donor));
            }
    }

    std::unique_ptr<TileScratch> scratch = std::make_unique<TileScratch>();
    BlockArray<std::int32_t> worked;
    std::array<std::int32_t, grid::kTileCells> after;
};

TEST(StructureKernels, AreTheSameOnEveryInstructionSet) {
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        const KernelInput input(seed);
        const auto moved = [&](core::Isa isa) {
            const auto structure = std::make_unique<StructureScratch>();
            structure->quanta = input.worked;
            structure->breakdown_strain.fill(1.3F);
            std::vector<std::int32_t> worked(grid::kTileCells);
            core::kernels<TileKernels>(isa).move_structure({1e6F}, *input.scratch, *structure,
                                                           input.after.data(), worked.data());
            return worked;
        };
        const auto loosened = [&](core::Isa isa) {
            std::vector<float> both(2 * kBlockCells, 123.4F);
            const std::vector<float> share(kBlockCells, 0.7F);
            core::kernels<TileKernels>(isa).loosen(input.worked.data(),
                                                   input.scratch->block.quanta.data(), kBlockCells,
                                                   share.data(), both.data(), both.data() + kBlockCells);
            return both;
        };
        for (const core::Isa isa : {core::Isa::Avx2, core::Isa::Avx512}) {
            if (isa > core::best_isa()) continue;
            EXPECT_EQ(moved(isa), moved(core::Isa::Baseline)) << core::name_of(isa);
            EXPECT_EQ(loosened(isa), loosened(core::Isa::Baseline)) << core::name_of(isa);
        }
    }
}

}  // namespace
}  // namespace pastoso::film::test
