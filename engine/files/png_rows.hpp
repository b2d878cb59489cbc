// PNG files read through libpng: what is wrong with them reaches the caller, and nobody else.
#pragma once

#include "files/picture_rows.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace pastoso::files {

/// Puts the next bytes of a file at `to`; returns how many there were, fewer at the end.
using NextBytes = std::function<std::size_t(void* to, std::size_t count)>;

/// `name` stands for the picture as picture_error() has it. Throws InputError when it is no PNG file or
/// too large.
std::unique_ptr<PictureRows> png_rows(NextBytes source, std::string name);

}  // namespace pastoso::files
