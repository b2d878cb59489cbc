#include "recordings/channel_names.hpp"

#include "core/text.hpp"

#include <set>

namespace pastoso::recordings {
namespace {

constexpr std::size_t kLongestName = 60;

std::string safe_name(const std::string& name, std::size_t number) {
    std::string safe;
    for (const char letter : name.substr(0, kLongestName)) {
        const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                           (letter >= '0' && letter <= '9');
        if (plain)
            safe += letter;
        else if (!safe.empty() && safe.back() != '_')
            safe += '_';
    }
    if (!safe.empty() && safe.back() == '_') safe.pop_back();
    if (safe.empty()) return "layer_" + std::to_string(number);
    return safe[0] >= '0' && safe[0] <= '9' ? "_" + safe : safe;
}

}  // namespace

std::vector<std::string> channel_names(const std::vector<std::string>& names) {
    std::set<std::string> taken = {kSupportChannels};
    std::vector<std::string> unique;
    for (const std::string& name : names) {
        const std::string wanted = safe_name(name, unique.size() + 1);
        std::string given = wanted;
        for (int count = 2; !taken.insert(core::lower_case(given)).second; ++count)
            given = wanted + "_" + std::to_string(count);
        unique.push_back(given);
    }
    return unique;
}

}  // namespace pastoso::recordings
