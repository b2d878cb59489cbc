#include "files/text_lines.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pastoso::files {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

}  // namespace

bool TextLines::next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    ++line_number_;
    return true;
}

std::string_view TextLines::word() {
    line_.remove_prefix(std::min(line_.find_first_not_of(kBlanks), line_.size()));
    const std::string_view found = line_.substr(0, line_.find_first_of(kBlanks));
    line_.remove_prefix(found.size());
    return found;
}

float TextLines::number() {
    const std::string_view written = word();
    if (written.empty()) fail("a number is missing.");
    std::string_view digits = written;
    if (digits.front() == '+') digits.remove_prefix(1);
    // In double precision: numbers too small for a float are 0, and those with nine digits the nearest.
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
        fail("%1 is no number.", quoted(written));
    const auto number = static_cast<float>(value);
    if (!std::isfinite(number)) fail("%1 is not finite in single precision.", quoted(written));
    return number;
}

void TextLines::fail(const core::Message& message) const {
    throw core::located_error(*file_, line_number_, message);
}

std::string quoted(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    std::string text(word.substr(0, kLongest));
    for (char& letter : text)
        if (letter < ' ' || letter > '~') letter = '?';
    return "\"" + text + (word.size() > kLongest ? "...\"" : "\"");
}

}  // namespace pastoso::files
