// The paint box: which of the paints there are lie before the painter, and in which order.
#pragma once

#include "pigment/palette.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::pigment {

/// The Colour Index names of {"box": ["PW6", ...]}, in order. `name` is the file's name for errors.
/// Throws InputError that names the entry: no list, an empty one, a name that is no text, is none of
/// `palette` or stands there twice.
std::vector<std::string> parse_box(std::string_view json_text, const std::string& name,
                                   std::span<const Pigment> palette);

/// The 22 paints of resources/pigments/box.json, white first, then around the colour circle to black.
/// Throws InputError when the program's own files are missing or broken.
const std::vector<Pigment>& default_box();

}  // namespace pastoso::pigment
