#include "cli/classic_tea.hpp"

#include "cli/frame_files.hpp"
#include "cli/frame_sequence.hpp"
#include "cli/stopwatch.hpp"
#include "cli/usage_error.hpp"
#include "core/hash.hpp"
#include "liquid/classic/classic_tea.hpp"
#include "liquid/surface/marching_cubes.hpp"
#include "liquid/surface/metaballs.hpp"

#include <optional>

namespace pastoso::cli {
namespace {

using liquid::ClassicSettings;
using liquid::ClassicTea;

constexpr int kSourceCells = 6;
/// Points of the lattice that surfaces are made on, along each side.
constexpr int kSurfacePoints = 96;
/// The constant a of the source's kernel: particles are balls of 2 mm, far enough from one another to
/// be told apart.
constexpr float kBall_m = 0.0022F;

void check_usage(const TeaOptions& options) {
    if (!options.scene.empty()) throw UsageError("--classic: the system of 2010 has no scene file.");
    if (!options.cache.empty()) throw UsageError("--classic: its frames cannot be kept in a cache.");
    if (!options.frames.empty() && FrameFiles::kind_of(options.files.format) != FrameFiles::Kind::Mesh)
        throw UsageError("--classic: it makes surfaces; give --format pbrt, obj, ply or stl.");
}

ClassicSettings settings_of(const TeaOptions& options) {
    ClassicSettings settings;
    if (options.cells) {
        settings.solver = liquid::ClassicSolver::Product;
        settings.cells = *options.cells;
    }
    if (options.seed) settings.seed = *options.seed;
    settings.step_s = static_cast<float>(1.0 / options.fps);
    liquid::check_classic(settings);
    return settings;
}

/// Makes the particles' surface.
class Surfaces {
  public:
    Surfaces(const ClassicSettings& settings, core::ThreadPool& pool)
        : balls_(pool),
          cubes_(pool),
          field_({kSurfacePoints, kSurfacePoints, kSurfacePoints,
                  settings.box_m / static_cast<float>(kSurfacePoints - 1)}) {}

    liquid::TriangleMesh make(const ClassicTea& tea) {
        liquid::Metaballs balls;
        balls.kernel = liquid::InverseSquareBalls{kBall_m};
        balls_.fill(tea.parcels(), balls, field_);
        liquid::TriangleMesh mesh;
        cubes_.run(field_.view(), liquid::kInverseSquareThreshold, {}, mesh);
        return mesh;
    }

  private:
    liquid::MetaballField balls_;
    liquid::MarchingCubes cubes_;
    liquid::SampledField field_;
};

void note_end(const ClassicTea& tea, liquid_files::TeaStats& stats) {
    const liquid::PileUp found = liquid::pile_up(tea.particles_m(), kSourceCells, tea.settings().box_m);
    stats.pile_up_dispersion = found.dispersion;
    stats.pile_up_at_borders = found.at_borders;
    stats.parcels = static_cast<std::int64_t>(tea.particles_m().size());
    core::Hash64 hash;
    hash.add(std::span<const glm::vec3>(tea.particles_m()));
    stats.state_hash = hash.value();
}

}  // namespace

liquid_files::TeaStats run_classic_tea(const TeaOptions& options, int frame_count,
                                       core::ThreadPool& pool) {
    check_usage(options);
    liquid_files::TeaStats stats;
    ClassicTea tea(settings_of(options));
    std::optional<FrameFiles> files;
    if (!options.frames.empty()) files.emplace(options.frames, "milk", options.files, pool);
    Surfaces surfaces(tea.settings(), pool);
    for_frames({1, frame_count}, {"swirling", options.quiet}, [&](int frame) {
        stats.simulate_s += seconds_of([&] { tea.step(pool); });
        ++stats.steps;
        if (!files || !files->is_wanted(frame)) return;
        liquid::TriangleMesh surface;
        files->costs().surface_s += seconds_of([&] { surface = surfaces.make(tea); });
        files->costs().triangles = static_cast<std::int64_t>(surface.triangles.size());
        files->write_mesh(frame, surface);
    });
    if (files) stats.files = files->costs();
    note_end(tea, stats);
    return stats;
}

}  // namespace pastoso::cli
