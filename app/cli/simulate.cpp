#include "cli/simulate.hpp"

#include "cli/interrupt.hpp"
#include "cli/printing.hpp"
#include "cli/progress.hpp"
#include "cli/scene_report.hpp"
#include "cli/scene_writer.hpp"
#include "cli/stopwatch.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "files/file_access.hpp"
#include "files/image.hpp"
#include "film/step_plan.hpp"

#include <cstdio>

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kSheetGap_px = 8;
/// Larger sheets are of no use to look at.
constexpr double kMaxSheetPixels = 6e7;

recordings::SceneFile load_scene(const SimulateOptions& options) {
    recordings::SceneFile file = recordings::read_scene(options.scene);
    if (options.seconds) {
        for (recordings::SceneRun& run : file.runs)
            recordings::shorten(run, *options.seconds);
    }
    return file;
}

/// Makes every film once, so that what cannot be made is refused before anything is written.
void check_runs(const recordings::SceneFile& file, const std::string& label, core::ThreadPool& pool) {
    for (const recordings::SceneRun& run : file.runs) {
        try {
            const film::Simulation trial(run.scene, pool);
        } catch (const core::InputError& error) {
            const std::string place = run.name.empty() ? label : label + ", run \"" + run.name + "\"";
            throw core::InputError("%1: %2", place, error.message());
        }
    }
}

fs::path folder_of(const recordings::SceneRun& run, const fs::path& folder) {
    return run.name.empty() ? folder : folder / run.name;
}

void make_folders(const recordings::SceneFile& file, const SimulateOptions& options) {
    if (!options.stats.empty()) files::check_writable(options.stats);
    files::make_folder(options.output);
    for (const recordings::SceneRun& run : file.runs)
        files::make_folder(folder_of(run, options.output));
}

/// How far all runs together are.
struct Course {
    Progress& progress;
    double passed_s = 0.0, all_s = 0.0;

    void update(double run_s) const { progress.update(all_s > 0.0 ? (passed_s + run_s) / all_s : 1.0); }
};

RunOutcome play(film::Simulation& simulation, SceneWriter& writer, const Course& course) {
    RunOutcome outcome;
    for (const double stop_s : writer.stops()) {
        outcome.film_s += seconds_of([&] { simulation.advance_to(stop_s, stop_if_interrupted); });
        writer.write_due(simulation);
        course.update(stop_s);
    }
    stop_if_interrupted();
    writer.write_tables();
    return outcome;
}

RunOutcome play_run(const recordings::SceneRun& run, bool cell_units, const fs::path& folder,
                    const recordings::PictureStyle& style, const Course& course,
                    core::ThreadPool& pool) {
    film::Simulation simulation(run.scene, pool);
    SceneWriter writer(run, cell_units, folder, style, pool);
    RunOutcome outcome = play(simulation, writer, course);
    outcome.name = run.name;
    outcome.moments = writer.moments();
    outcome.series = writer.series();
    outcome.pictures = writer.pictures();
    outcome.times = writer.times();
    outcome.film = simulation.report();
    outcome.state_hash = film::state_hash(simulation.film());
    return outcome;
}

/// All pictures on one sheet: a row for every run, or the single run's pictures in one.
void write_sheet(const std::vector<RunOutcome>& outcomes, const fs::path& path) {
    std::vector<std::vector<pigment::Image8>> rows;
    std::size_t count = 0;
    double pixels = 0.0;
    for (const RunOutcome& outcome : outcomes) {
        rows.push_back(outcome.pictures);
        count += outcome.pictures.size();
        for (const pigment::Image8& picture : outcome.pictures)
            pixels += static_cast<double>(picture.width) * picture.height;
    }
    if (count > 1 && pixels <= kMaxSheetPixels)
        files::write_image(path, shade::arranged(rows, kSheetGap_px));
}

/// Says where the film ran slower than it would.
void print_lag(const RunOutcome& outcome) {
    if (outcome.film.lagging_steps == 0) return;
    print(
        "%s: in %lld of %lld steps paint ran slower than it would, as no more than %g a second are "
        "taken.\n",
        outcome.name.empty() ? "film" : outcome.name.c_str(),
        static_cast<long long>(outcome.film.lagging_steps), static_cast<long long>(outcome.film.steps),
        film::kMostLargeSteps_per_s);
}

void print_summary(const recordings::SceneFile& file, const std::vector<RunOutcome>& outcomes,
                   const SimulateOptions& options, double wall_s) {
    if (!file.title.empty()) print("%s\n", file.title.c_str());
    print("%s", report_table(file, outcomes).c_str());
    for (const RunOutcome& outcome : outcomes)
        print_lag(outcome);
    print("%s: tables, pictures and heights, in %.1f s\n", options.output.c_str(), wall_s);
    if (!options.stats.empty()) print("%s: figures\n", options.stats.c_str());
}

}  // namespace

void run_simulate(const SimulateOptions& options) {
    const Stopwatch wall;
    watch_for_interrupts();
    const recordings::PictureStyle style = recordings::picture_style(options.picture);
    const recordings::SceneFile file = load_scene(options);
    core::ThreadPool pool(options.threads.value_or(file.threads));
    check_runs(file, options.scene, pool);
    make_folders(file, options);
    Progress progress("simulating", Progress::style_for_stderr(options.quiet));
    Course course{progress};
    for (const recordings::SceneRun& run : file.runs)
        course.all_s += run.scene.duration_s;

    std::vector<RunOutcome> outcomes;
    for (const recordings::SceneRun& run : file.runs) {
        outcomes.push_back(
            play_run(run, file.cell_units, folder_of(run, options.output), style, course, pool));
        course.passed_s += run.scene.duration_s;
    }
    const fs::path folder = options.output;
    write_sheet(outcomes, folder / "pictures.png");
    core::write_text_file(folder / "report.json", report_json(file, outcomes));
    const double wall_s = wall.seconds();
    if (!options.stats.empty())
        core::write_text_file(options.stats, simulate_stats_json(outcomes, pool.thread_count(), wall_s));
    progress.clear();
    print_summary(file, outcomes, options, wall_s);
}

}  // namespace pastoso::cli
