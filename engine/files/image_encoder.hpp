// A picture turned into the bytes of a file, a stretch of rows at a time.
#pragma once

#include "files/image_layout.hpp"
#include "files/images_abi.hpp"
#include "files/new_head.hpp"

#include <memory>
#include <string>

namespace pastoso::files {

class PngEncoder;

class ImageEncoder {
  public:
    /// Hands the file's bytes to `sink`. `name` stands for the picture in errors, `format` is OpenImageIO's name of
    /// one that holds such a layout; `png_effort` goes from 1, fast, to 9, small. Files say what their colours are:
    /// encoded ones hold `profile` or that of their space; PNG the same as cICP (ITU-T H.273) besides, where it is
    /// the space's; linear ones in TIFF the profile of linear light, in EXR chromaticities. Throws InputError when
    /// the library refuses the picture.
    ImageEncoder(core::Message name, const char* format, const ImageLayout& layout, int png_effort,
                 ByteSink sink);
    ~ImageEncoder();
    ImageEncoder(const ImageEncoder&) = delete;
    ImageEncoder& operator=(const ImageEncoder&) = delete;

    /// The next rows. Throws InputError when they cannot be encoded.
    void write_rows(const void* rows, int count);

    /// Completes the file after its last row. Throws InputError when that fails.
    void finish();

  private:
    void check(int status, const char* error) const;

    core::Message name_;
    ByteSink sink_;  ///< the library holds its address
    PastosoWriter* writer_ = nullptr;    ///< none for PNG
    std::unique_ptr<PngEncoder> png_{};  ///< none but for PNG
};

}  // namespace pastoso::files
