#include "core/value_range.hpp"

#include "core/error.hpp"

namespace pastoso::core {
namespace {

// Written so that what is no number fails.
bool lies_within(double value, double least, double most) {
    return value >= least && value <= most;
}

InputError outside(const Message& name, double value, double least, double most) {
    return InputError("%1 is %2, not between %3 and %4.", name, number_text(value, 6),
                      number_text(least, 6), number_text(most, 6));
}

}  // namespace

void check_range(std::string_view name, double value, double least, double most) {
    if (!lies_within(value, least, most)) throw outside(message_argument(name), value, least, most);
}

void check_range_of(Pattern<0> what, double value, double least, double most) {
    if (!lies_within(value, least, most)) throw outside(message(what), value, least, most);
}

}  // namespace pastoso::core
