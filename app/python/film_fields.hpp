// What every cell of a film holds, as floats in millimetres.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"

#include <span>
#include <string>

namespace pastoso::python {

/// One of the fields that Python may ask for.
struct FilmField {
    const char* name;
    int channels;         ///< numbers of a cell
    const char* meaning;  ///< with its unit, for documentation
    /// Writes the numbers of cells [first, first + count) of a tile.
    void (*read)(const film::FilmState& film, int tile, int first, int count, float* out);
};

std::span<const FilmField> film_fields();

/// Throws InputError that lists the names there are.
const FilmField& find_field(const std::string& name);

/// All cells row by row, `channels` numbers each, into memory for as many: the one conversion from
/// quanta in tiles.
void read_field(const film::FilmState& film, const FilmField& field, core::ThreadPool& pool, float* out);

}  // namespace pastoso::python
