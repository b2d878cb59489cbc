#include "cli/validate.hpp"

#include "cli/interrupt.hpp"
#include "cli/printing.hpp"
#include "cli/progress.hpp"
#include "cli/stopwatch.hpp"
#include "cli/validation_report.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "core/thread_pool.hpp"
#include "files/file_access.hpp"

#include <mutex>

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;
using film::validation::Case;

std::vector<const Case*> wanted_cases(const std::vector<std::string>& names) {
    std::vector<const Case*> wanted;
    if (names.empty())
        for (const Case& known : film::validation::cases())
            wanted.push_back(&known);
    for (const std::string& name : names)
        wanted.push_back(&film::validation::find_case(name));
    return wanted;
}

std::vector<film::Scheme> wanted_schemes(const std::string& scheme) {
    if (scheme == "explicit") return {film::Scheme::Explicit};
    if (scheme == "large") return {film::Scheme::LargeStep};
    return {film::Scheme::Explicit, film::Scheme::LargeStep};
}

std::vector<ValidatedRun> planned_runs(const ValidateOptions& options) {
    const std::vector<film::Scheme> schemes = wanted_schemes(options.scheme);
    std::vector<ValidatedRun> planned;
    for (const Case* wanted : wanted_cases(options.cases))
        for (const film::validation::Run& run : film::validation::runs_of(*wanted, schemes))
            if (options.with_long || !wanted->is_long(run)) planned.push_back({wanted, run, {}});
    if (planned.empty())
        throw core::InputError("All runs of these cases take minutes: --long carries them out.");
    for (ValidatedRun& plan : planned)
        plan.run.watch = stop_if_interrupted;
    return planned;
}

void list_cases(const std::vector<std::string>& names) {
    for (const Case* known : wanted_cases(names))
        print("%s\n    %s\n    %s\n", known->name.c_str(), known->law.c_str(), known->source.c_str());
}

/// The runs beside each other, each on one thread.
void carry_out(std::vector<ValidatedRun>& runs, int threads, bool quiet) {
    core::ThreadPool pool(threads);
    Progress progress("validating", Progress::style_for_stderr(quiet));
    std::mutex progress_use;
    std::size_t done = 0;
    pool.run(runs.size(), [&](std::size_t index, int) {
        runs[index].outcome = runs[index].wanted->outcome(runs[index].run);
        const std::lock_guard lock(progress_use);
        progress.update(static_cast<double>(++done) / static_cast<double>(runs.size()));
    });
    progress.clear();
}

void write_files(const std::vector<ValidatedRun>& runs, const fs::path& folder) {
    core::write_text_file(folder / "validation.csv", validation_csv(runs));
    core::write_text_file(folder / "validation.md", validation_markdown(runs));
    for (auto first = runs.begin(); first != runs.end();) {
        auto end = first;
        while (end != runs.end() && end->wanted == first->wanted)
            ++end;
        core::write_text_file(folder / (first->wanted->name + ".svg"), validation_plot({first, end}));
        first = end;
    }
}

}  // namespace

void run_validate(const ValidateOptions& options) {
    const Stopwatch wall;
    watch_for_interrupts();
    if (options.list) return list_cases(options.cases);
    std::vector<ValidatedRun> runs = planned_runs(options);
    if (!options.output.empty()) files::make_folder(options.output);
    carry_out(runs, options.threads, options.quiet);
    print("%s", validation_table(runs).c_str());
    if (options.output.empty()) return;
    write_files(runs, options.output);
    print("%s: table and plots, in %.1f s\n", options.output.c_str(), wall.seconds());
}

}  // namespace pastoso::cli
