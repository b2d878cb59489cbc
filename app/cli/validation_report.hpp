// What came of the runs of validation, as tables and plots.
#pragma once

#include "film/validation/runs.hpp"

#include <string>
#include <vector>

namespace pastoso::cli {

using film::validation::ValidatedRun;

/// A line for every figure, with aligned columns.
std::string validation_table(const std::vector<ValidatedRun>& runs);

/// case,quantity,scheme,cell_mm,angle_deg,measured,exact,error_percent,at_least
std::string validation_csv(const std::vector<ValidatedRun>& runs);

/// The errors as tables in Markdown: a line for every quantity, a column for every scheme and angle, in
/// each the three cell sizes from the coarsest on.
std::string validation_markdown(const std::vector<ValidatedRun>& runs);

/// The measured curves of one case's runs, and the exact one, as a picture in SVG.
std::string validation_plot(const std::vector<ValidatedRun>& runs);

}  // namespace pastoso::cli
