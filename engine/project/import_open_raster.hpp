// OpenRaster files of other programs as paint on a new canvas.
#pragma once

#include "project/picture_import.hpp"

#include <span>

namespace pastoso::project {

/// One layer of flat paint (layers/flat_paint.hpp) for every layer of the file, of its name, visibility,
/// opacity and group; the notes say what was left out. A file that holds a painting of Pastoso is
/// loaded as that (load_project()).
///
/// Nothing that the file names is looked for outside it, and sizes are checked before anything is
/// unpacked. Throws InputError "FILE, PLACE: ..." for a file that is damaged or too large.
LoadedProject import_open_raster(const std::filesystem::path& path, const ImportSettings& settings,
                                 core::ThreadPool& pool, const core::Progress& progress = {});

/// The same of a file in memory that is taken for another program's, whatever it holds; `name` stands
/// for it in errors.
LoadedProject parse_open_raster(std::span<const std::byte> file, const std::string& name,
                                const ImportSettings& settings, core::ThreadPool& pool);

/// Whether a file's name ends in .ora.
bool is_open_raster_path(const std::filesystem::path& path);

}  // namespace pastoso::project
