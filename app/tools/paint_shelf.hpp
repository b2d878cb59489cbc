// The paints that a painter finds again at the next start: used before, kept, mixed and named, and a
// palette opened. What is kept and mixed goes to others as a file of the same kind.
#pragma once

#include "document/events.hpp"
#include "document/puddles.hpp"
#include "pigment/gpl.hpp"
#include "tools/colour_aids.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::tools {

inline constexpr std::size_t kMostRecentPaints = 16;
inline constexpr std::size_t kMostKeptPaints = 64;
inline constexpr std::size_t kMostMixes = 256;

/// A mix that the painter has a word for.
struct NamedPaint {
    std::string name;  ///< not empty, and the only one of that name
    document::PaintRecipe paint;
    friend bool operator==(const NamedPaint&, const NamedPaint&) = default;
};

struct PaintShelf {
    std::vector<document::PaintRecipe> recent;  ///< the latest first, at most kMostRecentPaints
    std::vector<document::PaintRecipe> kept;    ///< the painter's palette, at most kMostKeptPaints
    std::vector<NamedPaint> mixes;              ///< in the painter's order, at most kMostMixes
    pigment::ColourPalette opened;              ///< of another program, or of a picture
    ColourAids aids;                            ///< of the wheel
    std::vector<document::Puddle> puddles;      ///< of a well, at most document::kMostPuddles
};

/// Puts the paint first among the recent ones.
void note_recent(const document::PaintRecipe& paint, PaintShelf& shelf);

/// Puts it last among those kept, unless it is there. False where there is no room for it.
bool keep_paint(const document::PaintRecipe& paint, PaintShelf& shelf);

/// Puts a mix last, under a name of its own: where there is one of that name, a number follows it.
/// False for a name of blanks, and where there is no room for it.
bool keep_mix(const NamedPaint& mix, PaintShelf& shelf);

/// Gives a mix that name, or the next free one. False for a name of blanks.
bool rename_mix(std::size_t index, const std::string& name, PaintShelf& shelf);

/// The kept paints and mixes of a shelf alone, as others may have them.
PaintShelf paint_set(const PaintShelf& shelf);

/// Adds the kept paints and mixes of `set` that are not there yet, as far as there is room. How many
/// were added.
int add_paint_set(const PaintShelf& set, PaintShelf& shelf);

/// An empty shelf where there is no such file. Throws InputError that names the file, the place in it
/// and the value for anything malformed, and for paints that there are not.
PaintShelf read_shelf(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_shelf(const PaintShelf& shelf, const std::filesystem::path& file);

}  // namespace pastoso::tools
