// A project as the entries of an archive.
#pragma once

#include "project/project.hpp"
#include "project/zip_file.hpp"
#include "shade/render.hpp"

namespace pastoso::project {

/// Everything that save_project() writes; other programs see `picture`.
ZipWriter project_archive(const Project& project, const shade::LinearImage& picture,
                          core::ThreadPool& pool);

}  // namespace pastoso::project
