// Small things that are done with text.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::core {

/// `text` with the letters A to Z in lower case, whatever the locale.
inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return lower;
}

/// Whether nothing of it is seen.
inline bool is_blank(std::string_view text) {
    return text.find_first_not_of(" \t") == std::string_view::npos;
}

/// "NAME, NAME", as messages and help list them.
inline std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

}  // namespace pastoso::core
