// A picture file that is written a stretch of rows at a time, so that pictures may be larger than
// memory.
#pragma once

#include "core/output_file.hpp"
#include "files/image_encoder.hpp"

#include <filesystem>
#include <string>

namespace pastoso::files {

class ImageWriter {
  public:
    /// Writes into `file`, in the format that its name ends in, as ImageEncoder does. Throws InputError as
    /// check_layout() does, and when the file cannot be written.
    ImageWriter(core::OutputFile& file, const ImageLayout& layout);

    /// The next rows. Throws InputError when they cannot be written.
    void write_rows(const void* rows, int count);

    /// Completes the file after its last row. Throws InputError when that fails.
    void finish();

  private:
    core::OutputFile& file_;
    ImageEncoder encoder_;
};

/// Writes a picture aside from rows that are in memory.
void write_rows_aside(const std::filesystem::path& path, const ImageLayout& layout, const void* rows);

/// A whole PNG file in memory, packed fast rather than small.
std::string encode_png(const ImageLayout& layout, const void* rows);

}  // namespace pastoso::files
