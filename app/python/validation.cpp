#include "core/error.hpp"
#include "core/progress.hpp"
#include "film/validation/runs.hpp"
#include "python/bindings.hpp"
#include "python/pools.hpp"
#include "python/turn.hpp"

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <pybind11/stl.h>

namespace pastoso::python {
namespace {

namespace py = pybind11;
using film::validation::Case;
using film::validation::Figure;
using film::validation::ValidatedRun;

py::dict cases() {
    py::dict result;
    for (const Case& known : film::validation::cases()) {
        py::dict entry;
        entry["law"] = known.law;
        entry["source"] = known.source;
        result[py::str(known.name)] = entry;
    }
    return result;
}

py::dict row_of(const ValidatedRun& run, const Figure& figure) {
    py::dict row;
    row["case"] = run.wanted->name;
    row["quantity"] = figure.quantity;
    row["scheme"] = film::validation::name_of(run.run.scheme);
    row["cell_mm"] = run.run.cell_mm;
    row["angle_deg"] = film::validation::angle_of(run, figure);
    row["measured"] = figure.measured;
    row["exact"] = figure.exact;
    row["error_percent"] = 100.0 * film::validation::error_of(figure);
    row["at_least"] = figure.at_least;
    return row;
}

void carry_out(std::vector<ValidatedRun>& runs, core::ThreadPool& pool) {
    Interruption interruption;
    std::atomic<bool> stopped = false;
    // Python hears of signals on the thread that called it, which is one of those that compute.
    const auto watch = [&, caller = std::this_thread::get_id()] {
        if (std::this_thread::get_id() == caller && interruption.wanted()) stopped = true;
        if (stopped) throw core::GivenUp{};
    };
    {
        const py::gil_scoped_release released;
        try {
            film::validation::carry_out(runs, pool, watch, [](double) {});
        } catch (const core::GivenUp&) {
        }
    }
    interruption.rethrow();
}

py::list validate(const py::args& cases, const std::string& scheme, bool with_long, int threads) {
    const std::vector<film::Scheme> schemes = film::validation::schemes_named(scheme);
    if (schemes.empty())
        throw core::InputError("there is no scheme \"%1\", only explicit, large and both.", scheme);
    std::vector<ValidatedRun> runs =
        film::validation::planned_runs(cases.cast<std::vector<std::string>>(), schemes, with_long);
    if (runs.empty())
        throw core::InputError("all runs of these cases take minutes; with_long=True carries them out.");
    carry_out(runs, *pool_of(threads));
    py::list rows;
    for (const ValidatedRun& run : runs)
        for (const Figure& figure : run.outcome.figures)
            rows.append(row_of(run, figure));
    return rows;
}

}  // namespace

void add_validation(py::module_& module) {
    module.def("validation_cases", &cases,
               "The cases of validate() by name: dicts of the law, in one line, and its source.");
    module.def(
        "validate", &validate, py::kw_only(), py::arg("scheme") = "both", py::arg("with_long") = false,
        py::arg("threads") = 0,
        "Holds the solver of paint against laws that are known exactly: the rows that\n"
        "`pastoso-cli validate` prints, a dict for each figure.\n\n"
        "case; quantity, with its unit in brackets; scheme, \"explicit\" or \"large\"; cell_mm;\n"
        "angle_deg, against the grid; measured and exact, in the unit of the quantity; error_percent,\n"
        "100 (measured - exact) / exact; at_least, whether it is more than `measured`, up to which was\n"
        "looked.\n\n"
        "cases: names of validation_cases(), or none for all. scheme: also \"both\". with_long: also\n"
        "runs of minutes. threads: how many carry out runs, 0 for one per processor. Python's other\n"
        "threads go on meanwhile; Ctrl+C stops it.");
}

}  // namespace pastoso::python
