// The paints that a painter finds again at the next start: used before, kept, and a palette opened.
#pragma once

#include "document/events.hpp"
#include "pigment/gpl.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace pastoso::tools {

inline constexpr std::size_t kMostRecentPaints = 16;
inline constexpr std::size_t kMostKeptPaints = 64;

struct PaintShelf {
    std::vector<document::PaintRecipe> recent;  ///< the latest first, at most kMostRecentPaints
    std::vector<document::PaintRecipe> kept;    ///< the painter's palette, at most kMostKeptPaints
    pigment::ColourPalette opened;              ///< of another program
};

/// Puts the paint first among the recent ones.
void note_recent(const document::PaintRecipe& paint, PaintShelf& shelf);

/// Puts it last among those kept, unless it is there. False where there is no room for it.
bool keep_paint(const document::PaintRecipe& paint, PaintShelf& shelf);

/// An empty shelf where there is no such file. Throws InputError that names the file, the place in it
/// and the value for anything malformed, and for paints that there are not.
PaintShelf read_shelf(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_shelf(const PaintShelf& shelf, const std::filesystem::path& file);

}  // namespace pastoso::tools
