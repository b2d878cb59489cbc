// The only way in which subcommands get options: a number with its range, a text that is not empty.
#pragma once

#include "core/number_text.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>

namespace pastoso::cli {

struct NumberRange {
    double least = 0.0, most = 0.0;
};

namespace detail {

template <class Value>
struct Plain {
    using Type = Value;
};
template <class Value>
struct Plain<std::optional<Value>> {
    using Type = Value;
};

template <class Target>
std::string shown_default(const Target& target) {
    if constexpr (std::is_arithmetic_v<Target>)
        return core::number_text(static_cast<double>(target));
    else
        return "";
}

/// The number that a text is, in the notation of C whatever the locale; nothing for what is none, is not
/// finite or is more than the type holds.
std::optional<double> number(const std::string& text);
std::optional<std::int64_t> whole_number(const std::string& text);

template <class Number>
auto number_as(const std::string& text) {
    if constexpr (std::is_floating_point_v<Number>)
        return number(text);
    else
        return whole_number(text);
}

/// Refuses what is no number or lies beyond the range; help shows it.
CLI::Validator in_range(const NumberRange& range, bool whole);

}  // namespace detail

/// An option for a number within a range; `target` is one, or an optional one, and outlives the parsing.
template <class Target>
CLI::Option* add_number(CLI::App& command, const std::string& name, Target& target,
                        const NumberRange& range, const std::string& meaning) {
    using Number = typename detail::Plain<Target>::Type;
    static_assert(std::is_arithmetic_v<Number>);
    const auto take = [&target](const CLI::results_t& texts) {
        target = static_cast<Number>(*detail::number_as<Number>(texts.back()));
        return true;
    };
    const auto show = [&target] { return detail::shown_default(target); };
    return command.add_option(name, take, meaning, false, show)
        ->check(detail::in_range(range, std::is_integral_v<Number>));
}

/// An option for a text, or for several; `target` outlives the parsing.
CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& target,
                      const std::string& meaning);
CLI::Option* add_text(CLI::App& command, const std::string& name, std::optional<std::string>& target,
                      const std::string& meaning);
CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& target,
                       const std::string& meaning);

}  // namespace pastoso::cli
