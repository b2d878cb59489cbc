// Paintings from files and arrays, and into files.
#pragma once

#include "document/actions/picture_actions.hpp"
#include "document/events.hpp"
#include "python/painting_work.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <pybind11/numpy.h>

namespace pastoso::python {

/// Of a text in the stroke format, for which `name` stands in sentences and whose relative paths start
/// at `folder`; without one, of the file that `name` is.
document::Recording recording_of(const std::optional<std::string>& text, const std::string& name,
                                 const std::filesystem::path& folder);

/// Paints a recording on a new canvas, until `interruption` says so.
std::unique_ptr<PaintingWork> replayed(document::Recording recording, const std::string& name,
                                       std::shared_ptr<core::ThreadPool> pool,
                                       Interruption& interruption);

/// A project, to go on with. Throws InputError as project::load_project() does.
std::unique_ptr<PaintingWork> opened(const std::filesystem::path& path,
                                     std::shared_ptr<core::ThreadPool> pool);

/// As a project, a recording or a picture, by the ending of the name. Within a turn. Throws InputError
/// where the name ends otherwise, or the file cannot be written.
void save(const std::filesystem::path& path, PaintingWork& work);

/// An array (height, width, 3 or 4) of encoded sRGB, and coverage where it has a fourth number. Throws
/// InputError for another shape.
document::SharedPicture picture_of(
    const pybind11::array_t<std::uint8_t, pybind11::array::c_style>& pixels);

}  // namespace pastoso::python
