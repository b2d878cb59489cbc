// What a journal costs while painting: broad strokes of thick paint, 200 pen samples a second, on a
// canvas of 1200 x 800 cells, as fast as they can be computed.
#include "document/painting.hpp"
#include "journal/journal_writer.hpp"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>

#include <benchmark/benchmark.h>

namespace pastoso::journal {
namespace {

constexpr int kSeconds = 20;

double cpu_s(clockid_t clock) {
    std::timespec time{};
    ::clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::filesystem::path bench_folder() {
    const char* folder = std::getenv("PASTOSO_BENCH_FOLDER");
    return (folder != nullptr ? std::filesystem::path(folder) : std::filesystem::temp_directory_path()) /
           "journal-benchmark";
}

/// A second each: a stroke of 0.8 s and a rest.
document::Recording strokes() {
    using namespace document;
    Recording recording;
    recording.canvas.px_per_mm = 4.0;
    recording.events = {{0, UseMedium{"heavy-body oil"}}, {0, TakeBrush{"flat", 20.0, 1}}};
    for (int second = 0; second < kSeconds; ++second) {
        LoadPaint load;
        load.paint.ingredients = {{second % 2 == 0 ? "PB29" : "PY35", 1.0}};
        recording.events.push_back({60 * second, load});
        for (int i = 0; i <= 160; ++i) {
            const double u = i / 160.0;
            const brush::PenSample sample{.time_s = second + 0.8 * u,
                                          .x_mm = 15.0 + 270.0 * u,
                                          .y_mm = 12.0 + 9.0 * second + 3.0 * std::sin(9.0 * u),
                                          .pressure = 0.6,
                                          .rotation_deg = 90.0};
            const std::int64_t tick = 60 * second + static_cast<std::int64_t>(48.0 * u);
            if (i == 0)
                recording.events.push_back({tick, PenDown{sample}});
            else
                recording.events.push_back({tick, PenMove{sample}});
        }
        recording.events.push_back({60 * second + 48, PenUp{}});
    }
    recording.end_tick = 60 * kSeconds;
    return recording;
}

/// Processor time of the painting's thread that went to the journal.
struct Cost {
    double own_s = 0.0;

    template <class Work>
    void add(const Work& work) {
        const double begin_s = cpu_s(CLOCK_THREAD_CPUTIME_ID);
        work();
        own_s += cpu_s(CLOCK_THREAD_CPUTIME_ID) - begin_s;
    }
};

void keep(JournalWriter& journal, const document::Painting& painting) {
    journal.note_tick(painting.tick());
    const document::StageTimes times = painting.stage_times();
    const double work_s = times.brush_s + times.film_s;
    if (!painting.stroke_in_progress() && journal.wants_checkpoint(work_s))
        journal.write_checkpoint(painting.state(), work_s);
}

void paint(const document::Recording& recording, document::Painting& painting, JournalWriter* journal,
           Cost& cost) {
    std::size_t next = 0;
    while (painting.tick() < recording.end_tick) {
        for (; next < recording.events.size() && recording.events[next].tick <= painting.tick();
             ++next) {
            painting.apply(recording.events[next].action);
            if (journal != nullptr) cost.add([&] { journal->note(recording.events[next]); });
        }
        painting.advance_tick();
        if (journal != nullptr) cost.add([&] { keep(*journal, painting); });
    }
}

void painting_with_journal(benchmark::State& run) {
    const document::Recording recording = strokes();
    Cost cost;
    double thread_s = 0.0, process_s = 0.0;
    for ([[maybe_unused]] const auto& pass : run) {
        core::ThreadPool pool;
        document::Painting painting(recording.canvas, pool);
        std::unique_ptr<JournalWriter> journal;
        if (run.range(0) != 0)
            journal =
                std::make_unique<JournalWriter>(bench_folder(), Beginning{.canvas = recording.canvas});
        const double thread_began_s = cpu_s(CLOCK_THREAD_CPUTIME_ID);
        const double process_began_s = cpu_s(CLOCK_PROCESS_CPUTIME_ID);
        paint(recording, painting, journal.get(), cost);
        thread_s += cpu_s(CLOCK_THREAD_CPUTIME_ID) - thread_began_s;
        if (journal) journal->discard();
        journal.reset();
        process_s += cpu_s(CLOCK_PROCESS_CPUTIME_ID) - process_began_s;
    }
    run.counters["own_share"] = cost.own_s / thread_s;
    run.counters["process_s"] = process_s / static_cast<double>(run.iterations());
    run.counters["thread_s"] = thread_s / static_cast<double>(run.iterations());
}
BENCHMARK(painting_with_journal)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pastoso::journal
