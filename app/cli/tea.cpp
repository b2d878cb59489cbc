#include "cli/tea.hpp"

#include "cli/classic_tea.hpp"
#include "cli/finish.hpp"
#include "cli/frame_sequence.hpp"
#include "cli/interrupt.hpp"
#include "cli/kept_tea.hpp"
#include "cli/printing.hpp"
#include "cli/tea_files.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "liquid/tea/milk_tea.hpp"
#include "liquid_files/tea_json.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace pastoso::cli {
namespace {

using liquid::MilkTea;
using liquid::TeaSettings;
using liquid_files::TeaStats;

TeaSettings settings_of(const TeaOptions& options) {
    TeaSettings settings = options.scene.empty() ? TeaSettings{} : liquid_files::read_tea(options.scene);
    if (options.cells) settings.cells = *options.cells;
    if (options.parcels) settings.parcels = *options.parcels;
    if (options.seed) settings.seed = *options.seed;
    settings = liquid_files::stepped_for(settings, options.fps);
    liquid::check_tea(settings);
    return settings;
}

trace::MilkBody milk_body(const std::string& name) {
    return name == "surface" ? trace::MilkBody::Surface : trace::MilkBody::Medium;
}

/// Where frames go, and what they cost.
struct Outputs {
    std::optional<TeaFiles> files;
    std::optional<KeptTea> cache;
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

/// Brings the tea to the state that was kept, where all frames before it are there; the frame it then
/// stands at.
int go_on(MilkTea& tea, int steps_per_frame, int frame_count, const KeptTea& kept) {
    try {
        std::optional<liquid::TeaState> state = kept.state();
        if (!state) return 0;
        const int frame = state->step / steps_per_frame;
        if (frame < 1 || frame > frame_count || !kept.has_all(frame - 1)) return 0;
        tea.set_state(std::move(*state));
        return frame;
    } catch (const core::InputError& error) {
        complain(std::string(error.what()) + " The tea begins from the start.");
        return 0;
    }
}

/// Pours from the start, or goes on where an earlier run ended.
void simulate(MilkTea& tea, const TeaOptions& options, SimulatedFrames frames, core::ThreadPool& pool,
              Outputs& outputs) {
    TeaStats& stats = outputs.stats;
    const auto measure =
        options.stats.empty() ? liquid::MeasureDivergence::No : liquid::MeasureDivergence::Yes;
    const int steps = liquid_files::steps_per_frame(tea.settings(), options.fps);
    frames.advance = [&](int) {
        stats.simulate_s += seconds_of([&] {
            for (int i = 0; i < steps; ++i)
                note_step(tea.step(pool, measure), stats);
        });
    };
    frames.put = [&](int frame) {
        if (outputs.wants(frame)) outputs.put(frame, tea.frame());
    };
    simulate_frames(frames, {"pouring", options.quiet});
    stats.parcels = static_cast<std::int64_t>(tea.parcels().size());
    stats.balls = tea.ball_count();
    if (tea.poured_m3() > 0.0)
        stats.milk_error_rel = std::abs(tea.milk_m3(pool) / tea.poured_m3() - 1.0);
    stats.state_hash = liquid_files::state_hash(tea);
}

/// Makes all that is wanted and not there yet: draws what is kept, simulates what follows.
void make_frames(const TeaSettings& settings, const TeaOptions& options, int frame_count,
                 core::ThreadPool& pool, Outputs& outputs) {
    const bool keeps_all = outputs.cache && outputs.cache->has_all(frame_count);
    // Without files to draw, only the figures of a simulation are left to be wanted.
    const bool simulates = !keeps_all || (!outputs.files && !options.stats.empty());
    std::optional<MilkTea> tea;
    if (simulates) tea.emplace(settings);
    SimulatedFrames frames;
    frames.last = frame_count;
    if (outputs.cache && !keeps_all) {
        const int steps = liquid_files::steps_per_frame(settings, options.fps);
        frames.stands_at = go_on(*tea, steps, frame_count, *outputs.cache);
        frames.keep = [&](int) {
            outputs.stats.files.io_s += seconds_of([&] { outputs.cache->write_state(tea->state()); });
        };
        frames.keep_every_s = options.checkpoint_s;
    }
    const FrameRange kept{1, keeps_all ? frame_count : frames.stands_at - 1};
    if (outputs.files && outputs.cache)
        draw_kept(kept, options.quiet, outputs.cache->frames(), *outputs.files, outputs.stats);
    if (simulates) simulate(*tea, options, std::move(frames), pool, outputs);
}

}  // namespace

void run_tea(const TeaOptions& options) {
    const Stopwatch watch;
    watch_for_interrupts();
    if (options.frames.empty() && options.cache.empty() && options.stats.empty())
        throw UsageError("tea: nothing would be kept; give --frames, --cache or --stats.");
    const int frame_count = count_frames(options.seconds, options.fps);
    core::ThreadPool pool(options.threads);
    if (options.classic) {
        TeaStats stats = run_classic_tea(options, frame_count, pool);
        return finish(stats, watch, pool, options.stats);
    }
    const TeaSettings settings = settings_of(options);
    Outputs outputs;
    if (!options.frames.empty())
        outputs.files.emplace(options.frames, options.files, settings, milk_body(options.milk), pool);
    if (!options.cache.empty())
        outputs.cache.emplace(options.cache, liquid_files::index_of(liquid_files::tea_to_json(settings),
                                                                    options.fps, frame_count));
    make_frames(settings, options, frame_count, pool, outputs);
    if (outputs.files) outputs.stats.files += outputs.files->costs();
    finish(outputs.stats, watch, pool, options.stats);
}

void run_tea_render(const TeaRenderOptions& options) {
    const Stopwatch watch;
    watch_for_interrupts();
    const liquid_files::FrameIndex index =
        liquid_files::read_frame_index(options.cache, liquid_files::kTeaCache);
    const TeaSettings settings = liquid_files::tea_from_json(index.scene, options.cache + "/tea.json");
    const FrameRange range = parse_frame_range(options.range, index.count);
    core::ThreadPool pool(options.threads);
    TeaFiles files(options.frames, options.files, settings, milk_body(options.milk), pool);
    TeaStats stats;
    draw_kept(range, options.quiet, {options.cache, index.scene_hash}, files, stats);
    stats.files += files.costs();
    finish(stats, watch, pool, options.stats);
}

}  // namespace pastoso::cli
