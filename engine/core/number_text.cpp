#include "core/number_text.hpp"

#include <array>
#include <charconv>

namespace pastoso::core {

std::string number_text(double value) {
    std::array<char, 32> digits;
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), result.ptr};
}

std::string number_text(double value, int digits) {
    std::array<char, 32> text;
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value,
                                      std::chars_format::general, digits);
    return {text.data(), result.ptr};
}

std::string hex_text(std::uint64_t value) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text(16, '0');
    for (int i = 0; i < 16; ++i)
        text[15 - i] = kDigits[(value >> (4 * i)) & 15U];
    return text;
}

}  // namespace pastoso::core
