#include "core/message.hpp"

namespace pastoso::core {
namespace {

bool is_place(std::string_view pattern, std::size_t i) {
    return pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] >= '1' && pattern[i + 1] <= '9';
}

/// The pattern with texts at its places. A translation may name a place that the pattern does not have:
/// it stays as it is.
std::string filled(std::string_view pattern, const std::vector<std::string>& texts) {
    std::string whole;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const std::size_t place =
            is_place(pattern, i) ? static_cast<std::size_t>(pattern[i + 1] - '1') : texts.size();
        if (place >= texts.size()) {
            whole += pattern[i];
            continue;
        }
        whole += texts[place];
        ++i;
    }
    return whole;
}

}  // namespace

Message Message::verbatim(std::string text) {
    Message message;
    message.words_ = std::move(text);
    return message;
}

Message::Message(const char* pattern, std::vector<Message> arguments)
    : words_(pattern), arguments_(std::move(arguments)), is_verbatim_(false) {}

std::string Message::text() const {
    return text([](const char* pattern) { return std::string(pattern); });
}

std::string Message::text(const Translation& translation) const {
    if (is_verbatim_) return words_;
    std::vector<std::string> texts;
    for (const Message& argument : arguments_)
        texts.push_back(argument.text(translation));
    return filled(translation(words_.c_str()), texts);
}

}  // namespace pastoso::core
