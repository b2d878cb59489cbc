// The solver held against laws that others have derived or measured: what a case is, and what comes of
// it.
#pragma once

#include "film/solver.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::film::validation {

/// One way to run a case.
struct Run {
    Scheme scheme = Scheme::LargeStep;  ///< or Explicit
    double cell_mm = 0.25;
    double angle_deg = 0.0;  ///< how far the case is turned against the grid
    std::function<void()> watch = [] {};  ///< called at every tick; may throw to stop
};

/// One number of a case beside what the law says.
struct Figure {
    std::string quantity;  ///< with its unit in brackets
    double measured = 0.0, exact = 0.0;
    bool at_least = false;                 ///< it is more than `measured`, up to which was looked
    std::optional<double> angle_deg = {};  ///< direction it was measured in, where that is not the run's
};

struct PlotPoint {
    double x = 0.0, y = 0.0;
};
using Curve = std::vector<PlotPoint>;

struct Outcome {
    std::vector<Figure> figures;
    Curve measured, exact;
};

struct Case {
    std::string name;                ///< as it is asked for: small letters and hyphens
    std::string law;                 ///< the exact solution in one line
    std::string source;              ///< who found it, and where
    std::vector<double> cells_mm;    ///< three, the coarsest first
    std::vector<double> angles_deg;  ///< {0} for a case without a direction
    std::string x_axis, y_axis;      ///< of its plot
    std::function<Outcome(const Run&)> outcome;
    /// Whether a run takes more than some ten seconds.
    std::function<bool(const Run&)> is_long = [](const Run&) { return false; };
};

/// (measured - exact) / exact; where that is 0, the difference itself.
double error_of(const Figure& figure);

/// All cases, in the order of the documentation.
std::span<const Case> cases();

/// Throws InputError that lists the names there are.
const Case& find_case(std::string_view name);

/// The runs of a case with these schemes: every cell size at every angle.
std::vector<Run> runs_of(const Case& wanted, std::span<const Scheme> schemes);

}  // namespace pastoso::film::validation
