#include "recordings/consistency_record.hpp"

#include <cmath>

namespace pastoso::recordings {
namespace {

using files::Json;
using files::JsonPlace;
using film::Consistencies;
using film::Consistency;

/// No paint has a larger number of either kind.
constexpr double kMostOfEither = 1e4;

float read_number(const JsonPlace& place) {
    const double number = place.number();
    if (!(number >= 0.0 && number <= kMostOfEither)) place.fail("expected 0 to 10000.");
    return static_cast<float>(number);
}

}  // namespace

Json consistencies_json(const Consistencies& consistencies) {
    if (consistencies.are_several()) return "several";
    if (!consistencies.uniform()) return "none";
    return {{"log_viscosity", consistencies.uniform()->log_viscosity},
            {"yield_stress_Pa", consistencies.uniform()->yield_stress_Pa}};
}

Consistencies read_consistencies(const JsonPlace& place) {
    if (place.value().is_object()) {
        place.allow_only({"log_viscosity", "yield_stress_Pa"});
        return Consistencies(Consistency{read_number(place.entry("log_viscosity")),
                                         read_number(place.entry("yield_stress_Pa"))});
    }
    const std::string word = place.text();
    if (word == "several") return Consistencies::several();
    if (word != "none") place.fail(R"(expected "none", "several" or the numbers of one.)");
    return {};
}

Consistencies told_by_paint(const brush::Contents& paint, const film::Medium& in_hand) {
    if (paint.volume_mm3 <= 0.0) return {};
    const Consistency one = film::consistency_of(in_hand);
    const auto is_about = [&](int channel, double wanted) {
        // Thin films carry few quanta, so that what a cell carries is rounded by thousandths.
        constexpr double kNear = 1e-2;
        return std::abs(paint.paint[channel] / paint.volume_mm3 - wanted) <= kNear * (1.0 + wanted);
    };
    const bool same = is_about(film::kViscosityChannel, one.log_viscosity) &&
                      is_about(film::kYieldChannel, one.yield_stress_Pa);
    return same ? Consistencies(one) : Consistencies::several();
}

}  // namespace pastoso::recordings
