#include "core/value_range.hpp"

#include "core/error.hpp"

#include <sstream>

namespace pastoso::core {

void check_range(std::string_view name, double value, double least, double most) {
    // Written so that what is no number fails.
    if (value >= least && value <= most) return;
    std::ostringstream text;
    text << name << " is " << value << ", not between " << least << " and " << most << ".";
    throw InputError(text.str());
}

}  // namespace pastoso::core
