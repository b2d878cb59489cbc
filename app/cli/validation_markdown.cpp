#include "cli/validation_report.hpp"
#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace pastoso::cli {
namespace {

using film::validation::Figure;

struct Column {
    film::Scheme scheme;
    double angle_deg;
};
constexpr std::array<Column, 6> kColumns = {{{film::Scheme::Explicit, 0.0},
                                             {film::Scheme::Explicit, 27.0},
                                             {film::Scheme::Explicit, 45.0},
                                             {film::Scheme::LargeStep, 0.0},
                                             {film::Scheme::LargeStep, 27.0},
                                             {film::Scheme::LargeStep, 45.0}}};

/// "-8.8", "0.42", "> 300", with two digits that count.
std::string percent(const Figure& figure) {
    const double error = 100.0 * film::validation::error_of(figure);
    char text[32];
    std::snprintf(text, sizeof text,
                  std::abs(error) < 0.995  ? "%.2f"
                  : std::abs(error) < 9.95 ? "%.1f"
                                           : "%.0f",
                  error);
    return (figure.at_least ? "> " : "") + std::string(text == std::string("-0.00") ? "0.00" : text);
}

/// What a run of that kind measured of the quantity; a dash where there is none.
std::string error_in(const std::vector<const ValidatedRun*>& runs, const std::string& quantity,
                     double cell_mm, const Column& column) {
    for (const ValidatedRun* run : runs)
        for (const Figure& figure : run->outcome.figures)
            if (figure.quantity == quantity && run->run.scheme == column.scheme &&
                run->run.cell_mm == cell_mm &&
                film::validation::angle_of(*run, figure) == column.angle_deg)
                return percent(figure);
    return "-";
}

std::string errors_in(const std::vector<const ValidatedRun*>& runs, const std::string& quantity,
                      const Column& column) {
    std::string text;
    bool any = false;
    for (const double cell_mm : runs.front()->wanted->cells_mm) {
        const std::string error = error_in(runs, quantity, cell_mm, column);
        any = any || error != "-";
        text += (text.empty() ? "" : " / ") + error;
    }
    return any ? text : "";
}

std::string rows_of(const std::vector<const ValidatedRun*>& runs) {
    std::vector<std::string> quantities;
    for (const ValidatedRun* run : runs)
        for (const Figure& figure : run->outcome.figures)
            if (std::find(quantities.begin(), quantities.end(), figure.quantity) == quantities.end())
                quantities.push_back(figure.quantity);
    std::string cells;
    for (const double cell_mm : runs.front()->wanted->cells_mm)
        cells += (cells.empty() ? "" : " / ") + core::number_text(cell_mm, 4);
    std::string rows;
    for (const std::string& quantity : quantities) {
        rows += "| " + runs.front()->wanted->name + " | " + quantity + " | " + cells;
        for (const Column& column : kColumns)
            rows += " | " + errors_in(runs, quantity, column);
        rows += " |\n";
    }
    return rows;
}

}  // namespace

std::string validation_markdown(const std::vector<ValidatedRun>& runs) {
    std::string text = "| case | quantity | cells, mm |";
    for (const Column& column : kColumns)
        text += " " + film::validation::name_of(column.scheme) + ", " +
                core::number_text(column.angle_deg) + "° |";
    text += "\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    std::vector<const ValidatedRun*> of_case;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        of_case.push_back(&runs[i]);
        if (i + 1 < runs.size() && runs[i + 1].wanted == runs[i].wanted) continue;
        text += rows_of(of_case);
        of_case.clear();
    }
    return text;
}

}  // namespace pastoso::cli
