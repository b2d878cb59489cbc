#include "tools/medium_numbers.hpp"

#include "core/check.hpp"

#include <algorithm>

namespace pastoso::tools {
namespace {

using film::Medium;

/// Two numbers of which the first is never larger.
struct OrderedPair {
    double Medium::*lower;
    double Medium::*upper;
};
constexpr OrderedPair kOrdered[] = {{&Medium::receding_angle_deg, &Medium::advancing_angle_deg},
                                    {&Medium::alpha_min, &Medium::alpha_max}};

}  // namespace

const film::MediumNumber& number_of(double Medium::*member) {
    const auto numbers = film::medium_numbers();
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const auto& number) { return number.member == member; });
    PASTOSO_CHECK(found != numbers.end());
    return *found;
}

Medium with_number(Medium medium, double Medium::*member, double value) {
    const film::MediumNumber& number = number_of(member);
    medium.*member = std::clamp(value, number.least, number.most);
    for (const OrderedPair& pair : kOrdered) {
        if (member == pair.lower) medium.*pair.upper = std::max(medium.*pair.upper, medium.*pair.lower);
        if (member == pair.upper) medium.*pair.lower = std::min(medium.*pair.lower, medium.*pair.upper);
    }
    medium.touch_dry_s =
        std::min(medium.touch_dry_s, film::kSlowestDrying_s_mm * medium.typical_thickness_mm);
    return medium;
}

}  // namespace pastoso::tools
