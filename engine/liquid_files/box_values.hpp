// Fields of a box as parts of files: rows one after the other, x fastest, then y, then z.
#pragma once

#include "files/part_file.hpp"
#include "grid/box_field.hpp"

#include <vector>

namespace pastoso::liquid_files {

/// Which samples of a field a file holds.
enum class BoxSamples {
    Cells,  ///< nx ny nz
    All,  ///< with ghosts and the faces behind the last cells: -kBoxGhosts to n + kBoxGhosts along each
          ///< axis
};

std::size_t sample_count(const grid::BoxShape& shape, BoxSamples samples);

void add_field(files::PartFileWriter& file, const grid::BoxField& field, BoxSamples samples);

/// What the file does not hold is 0. Throws InputError when a value is not finite.
grid::BoxField next_field(files::PartFileReader& file, const grid::BoxShape& shape, BoxSamples samples);

}  // namespace pastoso::liquid_files
