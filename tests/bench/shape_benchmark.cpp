// What it takes to sample the distance from a shape on a lattice, as a tank does at its beginning.
#include "tank/meshes.hpp"
#include "tank/shape.hpp"

#include <limits>
#include <memory>
#include <utility>

#include <benchmark/benchmark.h>

namespace pastoso::tank {
namespace {

Shape mesh_shape(liquid::TriangleMesh mesh) {
    return {MeshBody{"", std::make_shared<const liquid::TriangleMesh>(std::move(mesh)), {}, 1.0F}};
}

/// The cube from -1 to 1 in n^3 points; with `near`, distances of more than four cells need not be
/// exact.
void sample(benchmark::State& run, const Shape& shape) {
    const int n = static_cast<int>(run.range(0));
    const float cell = 2.0F / static_cast<float>(n);
    const float reach = run.range(1) != 0 ? 4.0F * cell : std::numeric_limits<float>::infinity();
    const ShapeDistance distance(shape);
    for (auto _ : run)
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    benchmark::DoNotOptimize(distance(cell * (glm::vec3(i, j, k) + 0.5F) - 1.0F, reach));
}
BENCHMARK_CAPTURE(sample, torus_of_20000_triangles, mesh_shape(test::torus_mesh(0.6F, 0.25F, 100)))
    ->ArgNames({"points", "near"})
    ->ArgsProduct({{64, 128}, {0, 1}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sample, ball_of_32768_triangles, mesh_shape(test::sphere_mesh({}, 0.7F, 6)))
    ->ArgNames({"points", "near"})
    ->ArgsProduct({{64}, {0, 1}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sample, cup, Shape{CupGlass{}})
    ->ArgNames({"points", "near"})
    ->Args({64, 0})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::tank
