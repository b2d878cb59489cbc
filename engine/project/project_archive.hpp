// A project as the entries of an archive.
#pragma once

#include "core/output_file.hpp"
#include "project/pictures.hpp"
#include "project/project.hpp"

namespace pastoso::project {

/// Writes everything that save_project() writes; other programs see `pictures`. Throws as ZipWriter::write() does.
void write_archive(const Project& project, const Pictures& pictures, core::ThreadPool& pool,
                   core::OutputFile& file);

}  // namespace pastoso::project
