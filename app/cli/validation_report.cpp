#include "cli/validation_report.hpp"

#include "core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pastoso::cli {
namespace {

using core::number_text;
using film::validation::angle_of;
using film::validation::Figure;
using film::validation::name_of;

/// Calls visit(run, figure) for all lines of the table.
template <class Visit>
void for_each_figure(const std::vector<ValidatedRun>& runs, const Visit& visit) {
    for (const ValidatedRun& run : runs)
        for (const Figure& figure : run.outcome.figures)
            visit(run, figure);
}

}  // namespace

std::string validation_table(const std::vector<ValidatedRun>& runs) {
    std::size_t name_width = 4, quantity_width = 8;
    for_each_figure(runs, [&](const ValidatedRun& run, const Figure& figure) {
        name_width = std::max(name_width, run.wanted->name.size());
        quantity_width = std::max(quantity_width, figure.quantity.size());
    });
    const int widths[] = {static_cast<int>(name_width), static_cast<int>(quantity_width)};
    char line[256];
    std::snprintf(line, sizeof line, "%-*s  %-*s  %-8s %7s %5s  %10s %10s %8s\n", widths[0], "case",
                  widths[1], "quantity", "scheme", "cell mm", "angle", "measured", "exact", "error %");
    std::string table = line;
    for_each_figure(runs, [&](const ValidatedRun& run, const Figure& figure) {
        const std::string measured = (figure.at_least ? ">" : "") + number_text(figure.measured, 4);
        std::snprintf(line, sizeof line, "%-*s  %-*s  %-8s %7.4g %5.3g  %10s %10.4g %+8.2f\n", widths[0],
                      run.wanted->name.c_str(), widths[1], figure.quantity.c_str(),
                      name_of(run.run.scheme).c_str(), run.run.cell_mm, angle_of(run, figure),
                      measured.c_str(), figure.exact, 100.0 * film::validation::error_of(figure));
        table += line;
    });
    return table;
}

std::string validation_csv(const std::vector<ValidatedRun>& runs) {
    std::string text = "case,quantity,scheme,cell_mm,angle_deg,measured,exact,error_percent,at_least\n";
    for_each_figure(runs, [&](const ValidatedRun& run, const Figure& figure) {
        text += run.wanted->name + ",\"" + figure.quantity + "\"," + name_of(run.run.scheme) + ',' +
                number_text(run.run.cell_mm, 6) + ',' + number_text(angle_of(run, figure), 6) + ',' +
                number_text(figure.measured, 7) + ',' + number_text(figure.exact, 7) + ',' +
                number_text(100.0 * film::validation::error_of(figure), 5) + ',' +
                (figure.at_least ? "1" : "0") + '\n';
    });
    return text;
}

}  // namespace pastoso::cli
