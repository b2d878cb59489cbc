#include "cli/option.hpp"

#include <charconv>
#include <cmath>

namespace pastoso::cli {
namespace {

template <class Number>
std::optional<Number> read_as(const std::string& text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
    return number;
}

/// Whole numbers without an exponent.
std::string words_of(double number) {
    const bool is_whole = std::abs(number) < 1e15 && number == std::floor(number);
    return is_whole ? std::to_string(static_cast<long long>(number)) : core::number_text(number);
}

std::string words_of(const NumberRange& range) {
    return words_of(range.least) + " to " + words_of(range.most);
}

CLI::Option* not_empty(CLI::Option* option) {
    const auto problem = [](const std::string& text) {
        return std::string(text.empty() ? "\"\" is no value" : "");
    };
    return option->check(CLI::Validator(problem, ""));
}

}  // namespace

namespace detail {

std::optional<double> number(const std::string& text) {
    const std::optional<double> number = read_as<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::int64_t> whole_number(const std::string& text) {
    return read_as<std::int64_t>(text);
}

CLI::Validator in_range(const NumberRange& range, bool whole) {
    const auto problem = [range, whole](const std::string& text) -> std::string {
        std::optional<double> value = number(text);
        if (whole && !whole_number(text)) value.reset();
        if (value && *value >= range.least && *value <= range.most) return {};
        return "\"" + text + "\" is no " + (whole ? "whole number" : "number") + " from " +
               words_of(range);
    };
    return {problem, words_of(range)};
}

}  // namespace detail

CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& target,
                      const std::string& meaning) {
    return not_empty(command.add_option(name, target, meaning));
}

CLI::Option* add_text(CLI::App& command, const std::string& name, std::optional<std::string>& target,
                      const std::string& meaning) {
    return not_empty(command.add_option(name, target, meaning));
}

CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& target,
                       const std::string& meaning) {
    return not_empty(command.add_option(name, target, meaning));
}

}  // namespace pastoso::cli
