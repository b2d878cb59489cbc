#include "cli/tank.hpp"

#include "cli/finish.hpp"
#include "cli/frame_sequence.hpp"
#include "cli/interrupt.hpp"
#include "cli/printing.hpp"
#include "cli/tank_files.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/text_file.hpp"
#include "liquid_files/frame_index.hpp"
#include "liquid_files/tank_checkpoint.hpp"
#include "liquid_files/tank_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace pastoso::cli {
namespace {

using liquid_files::TankSeriesRow;
using liquid_files::TankStats;
using tank::LiquidTank;

constexpr liquid_files::FrameIndexKind kTankFrames = {"tank.json", "pastoso-tank-frames",
                                                      "another tank"};

tank::TankScene scene_of(const TankOptions& options) {
    tank::TankScene scene = liquid_files::read_tank(options.scene);
    const std::vector<std::string> names = liquid_files::tank_method_names();
    if (!options.method.empty())
        scene.method =
            static_cast<tank::Method>(std::ranges::find(names, options.method) - names.begin());
    return scene;
}

/// What a frame took.
struct FrameWork {
    int steps = 0, iterations = 0;
    double seconds = 0.0;
};

/// A tank, what comes of it, and the folder where that goes.
class TankRun {
  public:
    TankRun(const TankOptions& options, const tank::TankScene& scene, int frame_count,
            core::ThreadPool& pool)
        : options_(options), pool_(pool), tank_(scene), measures_(tank_, pool) {
        if (options.frames.empty()) return;
        files_.emplace(options.frames, options.files, tank_, pool);
        const liquid_files::FrameIndex index =
            liquid_files::index_of(liquid_files::tank_to_json(scene), options.fps, frame_count);
        scene_hash_ = index.scene_hash;
        liquid_files::keep_frame_index(options.frames, kTankFrames, index);
    }

    /// Goes on where an earlier run ended, or begins.
    void simulate(int frame_count) {
        SimulatedFrames frames;
        frames.last = frame_count;
        if (files_) {
            frames.stands_at = go_on(frame_count);
            frames.keep = [&](int) { keep(); };
            frames.keep_every_s = options_.checkpoint_s;
        }
        if (frames.stands_at == 0) series_ = {row_of(look(), {})};
        frames.advance = [&](int frame) { advance(frame); };
        frames.put = [&](int frame) { put(frame); };
        simulate_frames(frames, {"flowing", options_.quiet});
    }

    TankStats stats() const {
        TankStats stats = stats_;
        if (files_) stats.files += files_->costs();
        const grid::BoxShape& shape = tank_.shape();
        stats.cells = std::int64_t{shape.nx} * shape.ny * shape.nz;
        stats.particles = static_cast<std::int64_t>(tank_.particles().size());
        stats.end = series_.back();
        for (const TankSeriesRow& row : series_)
            stats.volume_error_rel_max =
                std::max(stats.volume_error_rel_max, std::abs(row.volume_error_rel));
        stats.state_hash = liquid_files::state_hash(tank_.state());
        return stats;
    }

  private:
    std::filesystem::path checkpoint_path() const {
        return liquid_files::tank_checkpoint_path(options_.frames);
    }

    /// Brings the tank to the state that was kept, where all files before it are there; the frame it
    /// then stands at.
    int go_on(int frame_count) {
        if (!core::is_there(checkpoint_path())) return 0;
        try {
            liquid_files::TankCheckpoint kept =
                liquid_files::read_tank_checkpoint(checkpoint_path(), scene_hash_);
            const int frame = static_cast<int>(kept.series.size()) - 1;
            if (frame < 1 || frame > frame_count) return 0;
            for (int before = 1; before < frame; ++before)
                if (files_->is_wanted(before)) return 0;
            tank_.set_state(std::move(kept.state), pool_);
            series_ = std::move(kept.series);
            return frame;
        } catch (const core::InputError& error) {
            complain(std::string(error.what()) + " The tank begins from the start.");
            return 0;
        }
    }

    void keep() {
        stats_.files.io_s += seconds_of([&] {
            liquid_files::write_tank_checkpoint(checkpoint_path(), {tank_.state(), series_},
                                                scene_hash_);
        });
    }

    void advance(int frame) {
        work_ = {};
        work_.seconds = seconds_of([&] {
            work_.steps = tank_.advance_to(frame / options_.fps, pool_, [&](const tank::TankStep& step) {
                work_.iterations = std::max(work_.iterations, step.pressure.iterations);
                stats_.not_converged += step.pressure.converged ? 0 : 1;
            });
        });
        stats_.simulate_s += work_.seconds;
        stats_.steps += work_.steps;
        stats_.pcg_iterations_max = std::max(stats_.pcg_iterations_max, work_.iterations);
    }

    MeasuredFrame look() {
        MeasuredFrame seen;
        stats_.files.surface_s += seconds_of([&] { seen = measures_.measured(); });
        return seen;
    }

    TankSeriesRow row_of(const MeasuredFrame& seen, const FrameWork& work) const {
        TankSeriesRow row;
        row.time_s = tank_.time_s();
        row.volume_m3 = liquid::volume_m3(seen.surface);
        const double due_m3 =
            (series_.empty() ? row.volume_m3 : series_.front().volume_m3) + tank_.brought_m3();
        if (due_m3 > 0.0) row.volume_error_rel = row.volume_m3 / due_m3 - 1.0;
        row.front_x_m = seen.front_x_m;
        row.fastest_m_s = static_cast<double>(tank_.fastest_m_s());
        row.steps = tank_.steps();
        row.pressure_iterations = work.iterations;
        if (work.steps > 0) row.step_s = work.seconds / work.steps;
        return row;
    }

    /// The row first: whoever stops the run while the file is made goes on with it.
    void put(int frame) {
        const bool has_row = static_cast<int>(series_.size()) > frame;
        const bool is_wanted = files_ && files_->is_wanted(frame);
        if (has_row && !is_wanted) return;
        const MeasuredFrame seen = look();
        if (!has_row) series_.push_back(row_of(seen, work_));
        if (!files_) return;
        stats_.files.io_s += seconds_of([&] {
            core::write_text_file(std::filesystem::path(options_.frames) / "series.csv",
                                  liquid_files::series_csv(series_));
        });
        if (is_wanted) files_->write(frame, seen);
    }

    const TankOptions& options_;
    core::ThreadPool& pool_;
    LiquidTank tank_;
    TankMeasures measures_;
    std::optional<TankFiles> files_;
    std::uint64_t scene_hash_ = 0;
    std::vector<TankSeriesRow> series_;  ///< of frame 0 and all that were put
    FrameWork work_;                     ///< of the frame it stands at
    TankStats stats_;
};

}  // namespace

void run_tank(const TankOptions& options) {
    const Stopwatch watch;
    watch_for_interrupts();
    if (options.frames.empty() && options.stats.empty())
        throw UsageError("tank: nothing would be kept; give --frames or --stats.");
    const int frame_count = count_frames(options.seconds, options.fps);
    const tank::TankScene scene = scene_of(options);
    core::ThreadPool pool(options.threads);
    TankRun run(options, scene, frame_count, pool);
    run.simulate(frame_count);
    TankStats stats = run.stats();
    finish(stats, watch, pool, options.stats);
}

}  // namespace pastoso::cli
