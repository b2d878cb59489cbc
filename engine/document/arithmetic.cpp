#include "document/arithmetic.hpp"

namespace pastoso::document {

core::Message arithmetic_note(int arithmetic) {
    if (arithmetic == kArithmetic) return {};
    return core::message(
        "were painted with an earlier version of the program (arithmetic %1, now %2): replayed, they "
        "come "
        "out a little differently.",
        arithmetic, kArithmetic);
}

}  // namespace pastoso::document
