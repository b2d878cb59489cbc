// Colour palettes of GIMP, Krita, Inkscape and others (.gpl), read and written.
#pragma once

#include "pigment/hex_colour.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace pastoso::pigment {

struct NamedColour {
    std::string name;  ///< may be empty, and need not be the only one of that name
    Srgb8 colour{};
};

struct ColourPalette {
    std::string name;
    std::vector<NamedColour> colours;
};

/// Reads a .gpl text: the line "GIMP Palette", then "Name: ..." and other such lines, then one line for
/// each colour with red, green and blue from 0 to 255 and the rest its name. What follows a # at the
/// start of a line is skipped. `file` is the file's name for errors. Throws InputError that names line
/// and value, and for a file without a colour.
ColourPalette parse_gpl(std::string_view text, const std::string& file);

/// The same palette as such a text. Line breaks and tabs in names become blanks.
std::string gpl_text(const ColourPalette& palette);

/// The first colour of that name, or nothing.
const NamedColour* find_colour(const ColourPalette& palette, std::string_view name);

}  // namespace pastoso::pigment
