#include "core/error.hpp"
#include "core/text.hpp"
#include "film/validation/case.hpp"
#include "film/validation/contact_lines.hpp"
#include "film/validation/flows.hpp"

namespace pastoso::film::validation {

double error_of(const Figure& figure) {
    const double difference = figure.measured - figure.exact;
    return figure.exact == 0.0 ? difference : difference / figure.exact;
}

std::span<const Case> cases() {
    static const std::vector<Case> all = {nusselt_film(),   bingham_film(),    herschel_bulkley_film(),
                                          slope_current(),  round_current(),   gravity_ripple(),
                                          tension_ripple(), running_wave(),    yielded_heap(),
                                          yielded_slope(),  kept_marks(),      running_drop(),
                                          fingers(),        tension_front(),   resting_drop(),
                                          held_drop(),      retracting_strip()};
    return all;
}

const Case& find_case(std::string_view name) {
    std::vector<std::string> names;
    for (const Case& known : cases()) {
        if (known.name == name) return known;
        names.push_back(known.name);
    }
    throw core::InputError("There is no case \"%1\", only %2.", name, core::listed(names));
}

std::vector<Run> runs_of(const Case& wanted, std::span<const Scheme> schemes) {
    std::vector<Run> runs;
    for (const Scheme scheme : schemes)
        for (const double cell_mm : wanted.cells_mm)
            for (const double angle_deg : wanted.angles_deg)
                runs.push_back({.scheme = scheme, .cell_mm = cell_mm, .angle_deg = angle_deg});
    return runs;
}

}  // namespace pastoso::film::validation
