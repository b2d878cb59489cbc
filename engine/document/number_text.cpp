#include "document/number_text.hpp"

#include <array>
#include <charconv>

namespace pastoso::document {

std::string number_text(double value) {
    std::array<char, 32> digits;
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), result.ptr};
}

}  // namespace pastoso::document
