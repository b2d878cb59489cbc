#include "cli/recover.hpp"

#include "cli/interrupt.hpp"
#include "cli/printing.hpp"
#include "cli/progress.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "core/thread_pool.hpp"
#include "files/file_access.hpp"
#include "journal/recovery.hpp"

#include <cstdio>
#include <ctime>

namespace pastoso::cli {
namespace {

std::string name_of(const journal::Unfinished& painting) {
    return painting.folder.filename().string();
}

std::string time_text(std::chrono::system_clock::time_point when) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(when);
    std::tm parts{};
    ::localtime_r(&seconds, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts);
    return text;
}

void tell(const journal::Unfinished& painting) {
    const std::string when = time_text(painting.last_painted);
    if (!painting.fault.empty()) {
        print("%s: %s, cannot be read: %s\n", name_of(painting).c_str(), when.c_str(),
              painting.fault.text().c_str());
        return;
    }
    print("%s: %s, %g x %g mm, %zu changes not saved, %s\n", name_of(painting).c_str(), when.c_str(),
          painting.canvas.width_mm, painting.canvas.height_mm, painting.changes,
          painting.painting.empty() ? "without a file" : painting.painting.c_str());
}

/// The one of that name, or the latest.
const journal::Unfinished& chosen(const std::vector<journal::Unfinished>& paintings,
                                  const std::string& name) {
    if (paintings.empty()) throw core::InputError("there is no unfinished painting.");
    if (name.empty()) return paintings.front();
    for (const journal::Unfinished& painting : paintings)
        if (name_of(painting) == name) return painting;
    throw core::InputError("there is no unfinished painting %1; recover --list shows them.", name);
}

journal::Claim claimed(const journal::Unfinished& painting) {
    if (auto claim = journal::Claim::on(painting.folder)) return std::move(*claim);
    throw core::InputError("%1: another program is at it.", name_of(painting));
}

void recover_into(const std::string& path, const journal::Claim& claim, const RecoverOptions& options) {
    core::ThreadPool pool(options.threads);
    journal::Recovered recovered;
    {
        Progress progress("painting", Progress::style_for_stderr(options.quiet));
        recovered = journal::recover(claim.folder(), pool, [&](double share) {
            stop_if_interrupted();
            progress.update(share);
        });
    }
    for (const core::Message& note : recovered.notes)
        complain(note.text());
    stop_if_interrupted();
    project::save_project(path, recovered, pool);
    print("%s: the painting\n", path.c_str());
}

void check_options(const RecoverOptions& options) {
    const int wishes =
        (options.list ? 1 : 0) + (options.output.empty() ? 0 : 1) + (options.discard ? 1 : 0);
    if (wishes != 1)
        throw UsageError(
            "recover needs to know what to do: --list, or -o FILE.pastoso, or NAME --discard.");
    if (options.discard && options.name.empty())
        throw UsageError("recover --discard needs the NAME of the painting to forget.");
    if (options.output.empty()) return;
    if (!project::is_project_path(options.output)) {
        throw core::InputError("%1: a painting is saved as .pastoso; this name ends otherwise.",
                               options.output);
    }
    files::check_writable(options.output);
}

}  // namespace

void run_recover(const RecoverOptions& options) {
    watch_for_interrupts();
    check_options(options);
    const auto paintings = journal::unfinished_paintings(journal::journals_path());
    if (options.list) {
        for (const journal::Unfinished& painting : paintings)
            tell(painting);
        return;
    }
    const journal::Unfinished& painting = chosen(paintings, options.name);
    journal::Claim claim = claimed(painting);
    if (!options.output.empty()) recover_into(options.output, claim, options);
    stop_if_interrupted();
    if (!options.keep) claim.discard();
}

}  // namespace pastoso::cli
