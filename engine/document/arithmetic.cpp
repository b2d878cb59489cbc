#include "document/arithmetic.hpp"

namespace pastoso::document {

std::string arithmetic_note(int arithmetic) {
    if (arithmetic == kArithmetic) return {};
    return "were painted with an earlier version of the program (arithmetic " + std::to_string(arithmetic) +
           ", now " + std::to_string(kArithmetic) + "): replayed, they come out a little differently.";
}

}  // namespace pastoso::document
