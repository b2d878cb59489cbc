#include "pigment/gpl.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace pastoso::pigment {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Cuts off and returns what stands before the first of `separators`.
std::string_view take_until(std::string_view& rest, std::string_view separators) {
    const std::size_t length = std::min(rest.find_first_of(separators), rest.size());
    const std::string_view head = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    return head;
}

struct Line {
    const std::string& file;
    long number = 0;

    template <class... Arguments>
    core::InputError error(core::Pattern<sizeof...(Arguments)> pattern,
                           const Arguments&... arguments) const {
        return core::located_error(file, number, pattern, arguments...);
    }
};

std::uint8_t parse_channel(const Line& line, const core::Message& channel, std::string_view word) {
    if (word.empty()) throw line.error("the %1 is missing.", channel);
    int value = -1;
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (status != std::errc{} || end != word.data() + word.size() || value < 0 || value > 255)
        throw line.error("the %1 \"%2\" is not a whole number from 0 to 255.", channel, word);
    return static_cast<std::uint8_t>(value);
}

NamedColour parse_colour(const Line& line, std::string_view text) {
    static constexpr std::array kChannels = {core::Pattern<0>("red"), core::Pattern<0>("green"),
                                             core::Pattern<0>("blue")};
    NamedColour colour;
    for (std::size_t i = 0; i < kChannels.size(); ++i) {
        colour.colour[i] = parse_channel(line, core::message(kChannels[i]), take_until(text, kBlanks));
        text = trimmed(text);
    }
    colour.name = text;
    return colour;
}

/// "Name: Value" and the like, which stand before the colours.
bool is_property(std::string_view text) {
    const bool begins_with_letter = (text.front() | 0x20) >= 'a' && (text.front() | 0x20) <= 'z';
    return begins_with_letter && text.find(':') != std::string_view::npos;
}

std::string on_one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char letter) { return letter == '\n' || letter == '\r' || letter == '\t'; }, ' ');
    return text;
}

}  // namespace

ColourPalette parse_gpl(std::string_view text, const std::string& file) {
    constexpr std::string_view kName = "Name:";
    ColourPalette palette;
    Line line{file, 1};
    if (trimmed(take_until(text, "\n")) != "GIMP Palette")
        throw line.error("this is not a GIMP palette; it would begin with \"GIMP Palette\".");
    while (!text.empty()) {
        ++line.number;
        const std::string_view entry = trimmed(take_until(text, "\n"));
        if (entry.empty() || entry.front() == '#') continue;
        if (!palette.colours.empty() || !is_property(entry))
            palette.colours.push_back(parse_colour(line, entry));
        else if (entry.starts_with(kName))
            palette.name = trimmed(entry.substr(kName.size()));
    }
    if (palette.colours.empty()) throw core::InputError("%1: there is no colour in this palette.", file);
    return palette;
}

std::string gpl_text(const ColourPalette& palette) {
    std::string text = "GIMP Palette\nName: " + on_one_line(palette.name) + "\n#\n";
    for (const NamedColour& named : palette.colours) {
        for (const std::uint8_t channel : named.colour)
            text += std::to_string(channel) + ' ';
        text.back() = '\t';
        text += on_one_line(named.name) + '\n';
    }
    return text;
}

const NamedColour* find_colour(const ColourPalette& palette, std::string_view name) {
    const auto found = std::find_if(palette.colours.begin(), palette.colours.end(),
                                    [&](const NamedColour& colour) { return colour.name == name; });
    return found == palette.colours.end() ? nullptr : &*found;
}

}  // namespace pastoso::pigment
