// What "info" says about paints and colours.
#pragma once

#include <span>
#include <string>

namespace pastoso::cli {

/// The paints there are, each with its masstone, undertone and tint as a screen shows them beside
/// titanium white. Throws InputError at the end when a file of the user's own pigments has a fault.
void print_paints();

/// One paint, by its Colour Index name or as a colour like "#c03020". Throws InputError for neither.
void print_paint(const std::string& name);

/// The recipe nearest to a colour like "#7a5c3e" out of these paints (none: the box), and how near the
/// colour's own paint comes. Throws InputError for what is no colour or no pigment.
void print_closest(const std::string& colour, std::span<const std::string> paints);

/// Every colour of a .gpl file with its closest recipe out of the box. Throws InputError with the line.
void print_palette(const std::string& path);

}  // namespace pastoso::cli
