// A project as the entries of an archive.
#pragma once

#include "project/pictures.hpp"
#include "project/project.hpp"
#include "project/zip_file.hpp"

namespace pastoso::project {

/// Everything that save_project() writes; other programs see `pictures`.
ZipWriter project_archive(const Project& project, const Pictures& pictures, core::ThreadPool& pool);

}  // namespace pastoso::project
