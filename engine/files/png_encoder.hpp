// PNG files written through libpng, which is there at once: OpenImageIO loads hundreds of libraries.
#pragma once

#include "core/message.hpp"
#include "files/images_abi.hpp"
#include "files/new_head.hpp"

#include <cstddef>
#include <memory>
#include <string>

struct png_struct_def;
struct png_info_def;

namespace pastoso::files {

class PngEncoder {
  public:
    /// Of one to four channels of 8 or 16 bits: grey or colours, the last of two or four being alpha,
    /// not multiplied. `name` stands for the picture in errors. Throws InputError when libpng refuses
    /// it; what `sink` throws is passed on.
    PngEncoder(core::Message name, const PastosoPicture& picture, ByteSink sink);
    ~PngEncoder();
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    /// The next rows, from the top, without gaps. Throws InputError when libpng refuses them.
    void write_rows(const void* rows, int count);

    /// Completes the file after its last row. Throws InputError when rows are missing.
    void finish();

  private:
    template <class Work>
    void attempt(Work&& work);
    void write_head(const PastosoPicture& picture);

    struct Talk;
    std::unique_ptr<Talk> talk_;
    std::size_t row_bytes_;
    png_struct_def* png_ = nullptr;
    png_info_def* info_ = nullptr;
};

}  // namespace pastoso::files
