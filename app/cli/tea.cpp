#include "cli/tea.hpp"

#include "cli/classic_tea.hpp"
#include "cli/frame_sequence.hpp"
#include "cli/interrupt.hpp"
#include "cli/stopwatch.hpp"
#include "cli/tea_files.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "io/tea_cache.hpp"
#include "io/tea_json.hpp"
#include "liquid/milk_tea.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

namespace pastoso::cli {
namespace {

using io::TeaStats;
using liquid::MilkTea;
using liquid::TeaSettings;

/// Steps are at most as long as the scene says, and a whole number of them makes a frame.
int steps_per_frame(const TeaSettings& settings, double fps) {
    return std::max(1, static_cast<int>(std::ceil(1.0 / (fps * settings.step_s) - 1e-6)));
}

TeaSettings settings_of(const TeaOptions& options) {
    TeaSettings settings = options.scene.empty() ? TeaSettings{} : io::read_tea(options.scene);
    if (options.cells) settings.cells = *options.cells;
    if (options.seed) settings.seed = *options.seed;
    settings.step_s = 1.0 / (options.fps * steps_per_frame(settings, options.fps));
    liquid::check_tea(settings);
    return settings;
}

std::uint64_t hash_of(const std::string& text) {
    core::Hash64 hash;
    hash.add(std::as_bytes(std::span(text)));
    return hash.value();
}

std::uint64_t hash_of(const MilkTea& tea) {
    core::Hash64 hash;
    hash.add(std::span<const liquid::Parcel>(tea.parcels()));
    hash.add(std::span<const float>(tea.dissolved().values()));
    hash.add(std::span<const float>(tea.coldness().values()));
    return hash.value();
}

/// Frames of one scene in a folder.
struct KeptFrames {
    std::filesystem::path folder;
    std::uint64_t scene_hash = 0;

    std::filesystem::path path_of(int frame) const { return io::tea_frame_path(folder, frame); }
    liquid::TeaFrame read(int frame) const { return io::read_tea_frame(path_of(frame), scene_hash); }
};

/// The folder that keeps frames, and which of them are there already.
class Cache {
  public:
    /// Throws InputError when the folder keeps other tea.
    Cache(const std::filesystem::path& folder, io::TeaCacheIndex index)
        : kept_{folder, index.scene_hash} {
        if (std::filesystem::exists(folder / "tea.json")) {
            const io::TeaCacheIndex there = io::read_tea_index(folder);
            if (there.scene_hash != index.scene_hash || there.fps != index.fps)
                throw core::InputError(folder.string() +
                                       ": keeps frames of other tea; choose another folder.");
            index.count = std::max(index.count, there.count);
        }
        io::write_tea_index(folder, index);
        whole_ = io::whole_tea_frames(folder, index);
    }

    const KeptFrames& kept() const { return kept_; }

    bool has(int frame) const { return whole_.at(static_cast<std::size_t>(frame) - 1); }
    bool is_complete(int count) const {
        return std::all_of(whole_.begin(), whole_.begin() + count, [](bool whole) { return whole; });
    }
    void write(int frame, const liquid::TeaFrame& content) const {
        io::write_tea_frame(kept_.path_of(frame), content, kept_.scene_hash);
    }

  private:
    KeptFrames kept_;
    std::vector<bool> whole_;
};

/// Where frames go, and what they cost.
struct Outputs {
    std::optional<TeaFiles> files;
    std::optional<Cache> cache;
    TeaStats stats;

    bool wants(int frame) const {
        return (cache && !cache->has(frame)) || (files && files->is_wanted(frame));
    }
    void put(int number, const liquid::TeaFrame& frame) {
        if (cache && !cache->has(number))
            stats.files.io_s += seconds_of([&] { cache->write(number, frame); });
        if (files && files->is_wanted(number)) files->write(number, frame);
    }
};

void note_step(const liquid::TeaStep& step, TeaStats& stats) {
    ++stats.steps;
    stats.pcg_iterations_max = std::max(stats.pcg_iterations_max, step.pressure.iterations);
    stats.divergence_max = std::max(stats.divergence_max, static_cast<double>(step.divergence_per_s));
    stats.not_converged += step.pressure.converged ? 0 : 1;
}

void simulate(const TeaSettings& settings, const TeaOptions& options, int frame_count,
              core::ThreadPool& pool, Outputs& outputs) {
    TeaStats& stats = outputs.stats;
    const auto measure =
        options.stats.empty() ? liquid::MeasureDivergence::No : liquid::MeasureDivergence::Yes;
    MilkTea tea(settings);
    for_frames({1, frame_count}, {"pouring", options.quiet}, [&](int frame) {
        stats.simulate_s += seconds_of([&] {
            for (int i = 0; i < steps_per_frame(settings, options.fps); ++i)
                note_step(tea.step(pool, measure), stats);
        });
        if (outputs.wants(frame)) outputs.put(frame, tea.frame());
    });
    stats.parcels = static_cast<std::int64_t>(tea.parcels().size());
    stats.balls = tea.ball_count();
    if (tea.poured_m3() > 0.0)
        stats.milk_error_rel = std::abs(tea.milk_m3(pool) / tea.poured_m3() - 1.0);
    stats.state_hash = hash_of(tea);
}

/// Makes the files that are missing of frames that were kept.
void draw_kept(const FrameRange& range, bool quiet, const KeptFrames& kept, TeaFiles& files,
               TeaStats& stats) {
    for_frames(range, {"drawing", quiet}, [&](int frame) {
        if (!files.is_wanted(frame)) return;
        liquid::TeaFrame content;
        stats.files.io_s += seconds_of([&] { content = kept.read(frame); });
        files.write(frame, content);
    });
}

void finish(TeaStats& stats, const Stopwatch& watch, int threads, const std::string& path) {
    stats.wall_s = watch.seconds();
    stats.threads = threads;
    stats.version = PASTOSO_VERSION;
    if (!path.empty()) io::write_stats(path, stats);
}

}  // namespace

void run_tea(const TeaOptions& options) {
    const Stopwatch watch;
    watch_for_interrupts();
    if (options.frames.empty() && options.cache.empty() && options.stats.empty())
        throw UsageError("tea: nothing would be kept; give --frames, --cache or --stats.");
    const int frame_count = static_cast<int>(std::lround(options.seconds * options.fps));
    if (frame_count < 1) throw UsageError("--seconds: less than one frame.");
    core::ThreadPool pool(options.threads);
    if (options.classic) {
        TeaStats stats = run_classic_tea(options, frame_count, pool);
        return finish(stats, watch, pool.thread_count(), options.stats);
    }
    const TeaSettings settings = settings_of(options);
    Outputs outputs;
    if (!options.frames.empty())
        outputs.files.emplace(options.frames, options.files, settings.cup, pool);
    if (!options.cache.empty()) {
        const std::string scene = io::tea_to_json(settings);
        outputs.cache.emplace(options.cache,
                              io::TeaCacheIndex{scene, hash_of(scene), options.fps, frame_count});
    }
    // Without files to draw, only the figures of a simulation are left to be wanted.
    const bool keeps_all = outputs.cache && outputs.cache->is_complete(frame_count);
    if (!keeps_all || (!outputs.files && !options.stats.empty()))
        simulate(settings, options, frame_count, pool, outputs);
    else if (outputs.files)
        draw_kept({1, frame_count}, options.quiet, outputs.cache->kept(), *outputs.files, outputs.stats);
    if (outputs.files) outputs.stats.files += outputs.files->costs();
    finish(outputs.stats, watch, pool.thread_count(), options.stats);
}

void run_tea_render(const TeaRenderOptions& options) {
    const Stopwatch watch;
    watch_for_interrupts();
    const io::TeaCacheIndex index = io::read_tea_index(options.cache);
    const TeaSettings settings = io::tea_from_json(index.scene, options.cache + "/tea.json");
    const FrameRange range = parse_frame_range(options.range, index.count);
    core::ThreadPool pool(options.threads);
    TeaFiles files(options.frames, options.files, settings.cup, pool);
    TeaStats stats;
    draw_kept(range, options.quiet, {options.cache, index.scene_hash}, files, stats);
    stats.files += files.costs();
    finish(stats, watch, pool.thread_count(), options.stats);
}

}  // namespace pastoso::cli
