// Tests compare messages by what they say in English.
#pragma once

#include "core/message.hpp"

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::core {

inline bool operator==(const Message& message, std::string_view text) {
    return message.text() == text;
}

inline void PrintTo(const Message& message, std::ostream* to) {
    *to << message.text();
}

inline std::vector<std::string> texts_of(const std::vector<Message>& messages) {
    std::vector<std::string> texts;
    for (const Message& message : messages)
        texts.push_back(message.text());
    return texts;
}

}  // namespace pastoso::core
