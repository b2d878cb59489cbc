// What a person is told, apart from the language in which it is said.
#pragma once

#include "core/number_text.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pastoso::core {

/// English words with places, %1 to %9, for what stands in them. They are known when the program is
/// compiled, so that there is a list of all; with more or fewer places than arguments it does not
/// compile.
template <std::size_t kArguments>
class Pattern {
  public:
    consteval Pattern(const char* words) : words_(words) {
        if (highest_place(words) != kArguments) throw "places and arguments differ";
    }
    const char* words() const { return words_; }

  private:
    static consteval std::size_t highest_place(std::string_view words) {
        std::size_t highest = 0;
        for (std::size_t i = 0; i + 1 < words.size(); ++i) {
            const char digit = words[i + 1];
            if (words[i] != '%' || digit < '1' || digit > '9') continue;
            highest = std::max(highest, static_cast<std::size_t>(digit - '0'));
        }
        return highest;
    }

    const char* words_;
};

/// A pattern and what stands at its places, which may be messages themselves; or text that is the same
/// in every language: a name, a number, the words of another program. The pattern is the message's code:
/// translations are found by it (resources/translations, context "Engine").
class Message {
  public:
    /// What is said instead of a pattern, with the same places.
    using Translation = std::function<std::string(const char* pattern)>;

    /// Nothing is told.
    Message() = default;
    static Message verbatim(std::string text);
    Message(const char* pattern, std::vector<Message> arguments);

    bool empty() const { return words_.empty(); }
    /// The pattern, or the text that is the same in every language.
    const std::string& words() const { return words_; }
    const std::vector<Message>& arguments() const { return arguments_; }
    bool is_verbatim() const { return is_verbatim_; }

    /// In English.
    std::string text() const;
    std::string text(const Translation& translation) const;

    friend bool operator==(const Message&, const Message&) = default;

  private:
    std::string words_;
    std::vector<Message> arguments_;
    bool is_verbatim_ = true;
};

/// What may stand at a place of a pattern. Numbers are written as number_text() does.
inline Message message_argument(const Message& message) {
    return message;
}
inline Message message_argument(std::string_view text) {
    return Message::verbatim(std::string(text));
}
template <std::integral Number>
requires(!std::same_as<Number, char> && !std::same_as<Number, bool>) Message
    message_argument(Number number) {
    return Message::verbatim(std::to_string(number));
}
template <std::floating_point Number>
Message message_argument(Number number) {
    return Message::verbatim(number_text(number));
}

template <class... Arguments>
Message message(Pattern<sizeof...(Arguments)> pattern, const Arguments&... arguments) {
    return {pattern.words(), {message_argument(arguments)...}};
}

}  // namespace pastoso::core
