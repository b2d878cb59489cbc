// What surfaces cost: marching cubes, fields of metaballs, the milk's surface.
#include "core/random.hpp"
#include "liquid/tea/milk_surface.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

namespace pastoso::liquid {
namespace {

constexpr float kVolume = 26e-6F / 12000.0F;

/// sin x cos y + sin y cos z + sin z cos x: eight periods a side, 128^3 cells.
SampledField gyroid() {
    SampledField field(Lattice{129, 129, 129, 1.0F / 128.0F, {}});
    const float wave = 16.0F * std::numbers::pi_v<float>;
    for (int k = 0; k < 129; ++k)
        for (int j = 0; j < 129; ++j)
            for (int i = 0; i < 129; ++i) {
                const glm::vec3 p = wave * field.lattice().point_m(i, j, k);
                field.at(i, j, k) = std::sin(p.x) * std::cos(p.y) + std::sin(p.y) * std::cos(p.z) +
                                    std::sin(p.z) * std::cos(p.x);
            }
    return field;
}

void marching_cubes_gyroid(benchmark::State& run) {
    const SampledField field = gyroid();
    core::ThreadPool pool(static_cast<int>(run.range(0)));
    MarchingOptions options{MeshBorder::Open, run.range(1) != 0};
    MarchingCubes cubes(pool);
    TriangleMesh mesh;
    for (auto _ : run) {
        cubes.run(field.view(), 0.0F, options, mesh);
        benchmark::DoNotOptimize(mesh.triangles.data());
    }
    const auto triangles = static_cast<double>(mesh.triangles.size());
    run.counters["triangles"] = triangles;
    run.counters["Mtriangles/s"] =
        benchmark::Counter(1e-6 * triangles, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(marching_cubes_gyroid)
    ->ArgNames({"threads", "normals"})
    ->ArgsProduct({{1}, {0, 1}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(marching_cubes_gyroid)
    ->Name("marching_cubes_gyroid_wall")
    ->ArgNames({"threads", "normals"})
    ->ArgsProduct({{1, 2}, {1}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void marching_cubes_fresh_memory(benchmark::State& run) {
    const SampledField field = gyroid();
    core::ThreadPool pool(1);
    for (auto _ : run)
        benchmark::DoNotOptimize(marching_cubes(field.view(), 0.0F, pool, {MeshBorder::Open, true}));
}
BENCHMARK(marching_cubes_fresh_memory)->Unit(benchmark::kMillisecond);

/// A round cloud in the middle of the box, densest in its middle.
std::vector<Parcel> cloud(int count) {
    std::vector<Parcel> parcels;
    for (std::uint32_t index = 0; parcels.size() < static_cast<std::size_t>(count); ++index) {
        Parcel parcel;
        parcel.volume_m3 = kVolume;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            float sum = 0.0F;
            for (std::uint32_t part = 0; part < 3; ++part)
                sum += core::uniform_noise(index, 10 * axis + part) - 0.5F;
            parcel.position_m[static_cast<int>(axis)] = 0.05F + 0.03F * sum;
        }
        parcels.push_back(parcel);
    }
    return parcels;
}

Lattice box_lattice(int n) {
    return cell_centres({n, n, n, 0.1F / static_cast<float>(n)});
}

void fill_metaballs(benchmark::State& run, const BallKernel& kernel) {
    const std::vector<Parcel> parcels = cloud(static_cast<int>(run.range(0)));
    core::ThreadPool pool(1);
    MetaballField balls(pool);
    SampledField field(box_lattice(static_cast<int>(run.range(1))));
    for (auto _ : run)
        balls.fill(parcels, {kernel, kVolume}, field);
}
BENCHMARK_CAPTURE(fill_metaballs, compact, CompactBalls{})
    ->ArgsProduct({{1000, 10000, 100000}, {64, 128}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fill_metaballs, inverse_square, InverseSquareBalls{})
    ->ArgsProduct({{1000, 10000, 100000}, {64, 128}})
    ->Unit(benchmark::kMillisecond);

/// Every ball at every sample, the loop over balls in single precision; one layer of the lattice is
/// timed.
void all_pairs_inverse_square_layer(benchmark::State& run) {
    const std::vector<Parcel> parcels = cloud(static_cast<int>(run.range(0)));
    const int n = static_cast<int>(run.range(1));
    const Lattice lattice = box_lattice(n);
    std::vector<float> row(static_cast<std::size_t>(n));
    for (auto _ : run) {
        for (int j = 0; j < n; ++j) {
            std::fill(row.begin(), row.end(), 0.0F);
            const glm::vec3 start = lattice.point_m(0, j, n / 2);
            for (const Parcel& parcel : parcels) {
                const glm::vec3 d = start - parcel.position_m;
                const float across = d.y * d.y + d.z * d.z + 1e-12F;
                for (int i = 0; i < n; ++i) {
                    const float x = d.x + static_cast<float>(i) * lattice.spacing_m;
                    row[static_cast<std::size_t>(i)] += 1.0F / (across + x * x);
                }
            }
            benchmark::DoNotOptimize(row.data());
        }
    }
}
BENCHMARK(all_pairs_inverse_square_layer)->Args({10000, 128})->Unit(benchmark::kMillisecond);

/// 12,000 parcels packed as densely as milk is, and samples twice as fine as 64^3 cells.
void milk_surface(benchmark::State& run) {
    std::vector<Parcel> parcels;
    const float step_m = std::cbrt(kVolume);
    for (int n = 0; n < 12000; ++n) {
        const auto index = static_cast<std::uint32_t>(n);
        const glm::vec3 place(n % 23, n / 23 % 23, n / 529);
        const glm::vec3 shake(core::uniform_noise(index, 1), core::uniform_noise(index, 2),
                              core::uniform_noise(index, 3));
        parcels.push_back(
            {glm::vec3(0.035F, 0.035F, 0.01F) + step_m * (place + 2.0F * shake), kVolume, 1.0F, -1});
    }
    core::ThreadPool pool(1);
    MilkSurfaces surfaces(pool);
    MilkSurface milk;
    for (auto _ : run)
        milk = surfaces.make(parcels, {}, {64, 64, 64, 0.1F / 64.0F});
    run.counters["triangles"] = static_cast<double>(milk.mesh.triangles.size());
    run.counters["tries"] = milk.tries;
    run.counters["error_%"] = 100.0 * milk.volume_error();
}
BENCHMARK(milk_surface)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::liquid
