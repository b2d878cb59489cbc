// Cost of tracing a glass of milk tea, of its parts, and of taking the noise out.
#include "trace/denoise.hpp"
#include "trace/numbers.hpp"
#include "trace/sampler.hpp"
#include "trace/scenes.hpp"
#include "trace/tracer.hpp"
#include "trace/triangle_rays.hpp"

#include <vector>

#include <benchmark/benchmark.h>

namespace pastoso::trace {
namespace {

/// About 92 000 triangles, as milk on its way has.
liquid::TriangleMesh many_balls() {
    liquid::TriangleMesh mesh;
    Sampler sampler(1, 0, 0);
    for (int ball = 0; ball < 90; ++ball) {
        const glm::vec3 place(sampler.next(), sampler.next(), sampler.next());
        tests::add_ball(mesh, glm::vec3(0.025F, 0.025F, 0.01F) + place * glm::vec3(0.05F, 0.05F, 0.07F),
                        0.001F + 0.003F * sampler.next(), 16);
    }
    return mesh;
}

std::vector<MeshRay> random_rays() {
    std::vector<MeshRay> rays;
    Sampler sampler(2, 0, 0);
    for (int i = 0; i < 20000; ++i) {
        const float z = 1.0F - 2.0F * sampler.next();
        const glm::vec2 turn = cos_sin_of_turns(sampler.next()) * std::sqrt(1.0F - z * z);
        rays.push_back({{0.1F * sampler.next(), 0.1F * sampler.next(), 0.1F * sampler.next()},
                        {turn.x, turn.y, z},
                        1e-6F,
                        0.1F});
    }
    return rays;
}

void build_hierarchy(benchmark::State& run) {
    const liquid::TriangleMesh mesh = many_balls();
    for (auto _ : run)
        benchmark::DoNotOptimize(TriangleRays(mesh));
    run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(mesh.triangles.size()));
}
BENCHMARK(build_hierarchy)->Unit(benchmark::kMillisecond);

void closest_hits(benchmark::State& run) {
    const TriangleRays triangles(many_balls());
    const std::vector<MeshRay> rays = random_rays();
    for (auto _ : run)
        for (const MeshRay& ray : rays)
            benchmark::DoNotOptimize(triangles.closest(ray));
    run.SetItemsProcessed(run.iterations() * static_cast<std::int64_t>(rays.size()));
}
BENCHMARK(closest_hits)->Unit(benchmark::kMillisecond);

/// Thousandths of milk that are dissolved everywhere.
void trace_glass(benchmark::State& run) {
    Scene scene;
    scene.milk = many_balls();
    scene.milk_share = grid::BlockField(tests::even_milk(0.001F * static_cast<float>(run.range(0)), 64));
    core::ThreadPool pool(1);
    PathTracer tracer(scene, tests::small_picture(200), pool);
    for (auto _ : run)
        tracer.add_samples(1);
    run.SetItemsProcessed(static_cast<std::int64_t>(tracer.rays()));
}
BENCHMARK(trace_glass)->Arg(0)->Arg(10)->Arg(50)->Arg(110)->Unit(benchmark::kMillisecond);

void take_noise_out(benchmark::State& run) {
    core::ThreadPool pool(1);
    PathTracer tracer(tests::busy_glass(), tests::small_picture(400), pool);
    tracer.add_samples(4);
    for (auto _ : run)
        benchmark::DoNotOptimize(tracer.denoised());
}
BENCHMARK(take_noise_out)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pastoso::trace
