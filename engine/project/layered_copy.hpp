// A painting for other painting programs: its layers as pictures, in their files.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting_state.hpp"
#include "files/keep_going.hpp"

#include <cstddef>
#include <filesystem>

namespace pastoso::project {

/// Whether a file's name ends in .ora (OpenRaster) or .psd (Photoshop), as layered copies do.
bool is_layered_copy_path(const std::filesystem::path& path);

struct LayeredCopy {
    std::filesystem::path path;
};

struct LayeredCopyReport {
    files::ExportStatus status = files::ExportStatus::Stopped;
    int width_px = 0, height_px = 0;
    std::size_t layers = 0;
};

/// Writes the pictures of pictures.hpp, a pixel a cell, laid over one another as the painting is seen,
/// and the painting as one picture for programs that know no layers. Stopped or failed, the file is as
/// it was. Throws InputError for other names, for sides that the format does not hold (30,000 pixels in
/// .psd) and when the file cannot be written.
LayeredCopyReport save_layered_copy(const LayeredCopy& copy, const document::PaintingState& painting,
                                    core::ThreadPool& pool, const files::KeepGoing& keep_going);

/// Whether it can be written under this name, asked before the work that it takes. Throws InputError.
void check_layered_copy(const LayeredCopy& copy);

}  // namespace pastoso::project
