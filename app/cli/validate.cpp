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

namespace pastoso::cli {
namespace {

namespace fs = std::filesystem;
using film::validation::Case;

std::vector<ValidatedRun> planned_runs(const ValidateOptions& options) {
    std::vector<ValidatedRun> planned = film::validation::planned_runs(
        options.cases, film::validation::schemes_named(options.scheme), options.with_long);
    if (planned.empty())
        throw core::InputError("All runs of these cases take minutes: --long carries them out.");
    return planned;
}

void list(const Case& known) {
    print("%s\n    %s\n    %s\n", known.name.c_str(), known.law.c_str(), known.source.c_str());
}

void list_cases(const std::vector<std::string>& names) {
    for (const std::string& name : names)
        list(film::validation::find_case(name));
    if (!names.empty()) return;
    for (const Case& known : film::validation::cases())
        list(known);
}

void carry_out(std::vector<ValidatedRun>& runs, int threads, bool quiet) {
    core::ThreadPool pool(threads);
    Progress progress("validating", Progress::style_for_stderr(quiet));
    film::validation::carry_out(runs, pool, stop_if_interrupted,
                                [&](double share) { progress.update(share); });
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
