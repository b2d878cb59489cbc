// Picture files read through OpenImageIO, a few rows at a time.
#pragma once

#include "files/images_abi.hpp"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

struct FileCloser {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

struct PastosoReader {
    // In this order: the picture reads through the source, and that from the file.
    std::unique_ptr<std::FILE, FileCloser> file;
    std::unique_ptr<OIIO::Filesystem::IOFile> source;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
    int next_row = 0;
};

namespace pastoso::images {

/// OpenImageIO's message in one line, without its full stop.
std::string one_line(std::string message);

/// These return nothing, or a sentence's predicate. `format` is OpenImageIO's name of it; the file's
/// name is never asked. The descriptor remains the caller's.
std::string open(const char* format, int descriptor, std::unique_ptr<PastosoReader>& reader,
                 PastosoHead& head);

/// The next rows' first channels, as 32-bit floats.
std::string read_rows(PastosoReader& reader, int channels, int count, float* rows);

/// After the last row: libraries report success for what they have filled up themselves, and complain
/// aside.
std::string finish(PastosoReader& reader);

}  // namespace pastoso::images
