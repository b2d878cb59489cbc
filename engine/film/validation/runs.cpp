#include "film/validation/runs.hpp"

#include <mutex>

namespace pastoso::film::validation {
namespace {

std::vector<const Case*> wanted_cases(const std::vector<std::string>& names) {
    std::vector<const Case*> wanted;
    if (names.empty())
        for (const Case& known : cases())
            wanted.push_back(&known);
    for (const std::string& name : names)
        wanted.push_back(&find_case(name));
    return wanted;
}

}  // namespace

std::vector<Scheme> schemes_named(const std::string& name) {
    if (name == "both") return {Scheme::Explicit, Scheme::LargeStep};
    for (const Scheme known : {Scheme::Explicit, Scheme::LargeStep})
        if (name == name_of(known)) return {known};
    return {};
}

std::vector<ValidatedRun> planned_runs(const std::vector<std::string>& names,
                                       const std::vector<Scheme>& schemes, bool with_long) {
    std::vector<ValidatedRun> planned;
    for (const Case* wanted : wanted_cases(names))
        for (const Run& run : runs_of(*wanted, schemes))
            if (with_long || !wanted->is_long(run)) planned.push_back({wanted, run, {}});
    return planned;
}

void carry_out(std::vector<ValidatedRun>& runs, core::ThreadPool& pool,
               const std::function<void()>& watch, const std::function<void(double share)>& done) {
    std::mutex done_use;
    std::size_t count = 0;
    pool.run(runs.size(), [&](std::size_t index, int) {
        ValidatedRun& run = runs[index];
        run.run.watch = watch;
        run.outcome = run.wanted->outcome(run.run);
        const std::lock_guard lock(done_use);
        done(static_cast<double>(++count) / static_cast<double>(runs.size()));
    });
}

std::string name_of(Scheme scheme) {
    return scheme == Scheme::Explicit ? "explicit" : "large";
}

double angle_of(const ValidatedRun& run, const Figure& figure) {
    return figure.angle_deg.value_or(run.run.angle_deg);
}

}  // namespace pastoso::film::validation
