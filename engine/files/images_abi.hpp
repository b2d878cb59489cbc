// The narrow waist between the program and the module that reads and writes image files. The module
// links OpenImageIO, which loads hundreds of libraries; it is opened when the first image is read or
// written.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// Raised whenever a declaration below changes; a module of another number is refused.
inline constexpr int kPastosoImagesAbi = 9;

enum PastosoSampleType {
    kPastosoUint8 = 0,
    kPastosoUint16 = 1,
    kPastosoFloat = 2,  ///< stored as halves
    kPastosoData = 3,   ///< floats that are no colours, stored as they are
};

/// What a picture file is to hold. Rows are given from the top without gaps, channels interleaved.
/// Integers are encoded, floats linear.
struct PastosoPicture {
    int width, height, channels;
    int sample_type;                   ///< PastosoSampleType
    const char* const* channel_names;  ///< one for each channel; null: the usual ones
    const int* stored_types;           ///< of float channels, PastosoSampleType; null: all alike
    int holds_data;                    ///< 1: integers that are no colours
    double px_per_mm;                  ///< for the file's resolution entry; 0: left out
    const char* format;                ///< OpenImageIO's name of the file format
    const char* software;
    const char* description;  ///< a text for people; null: none
    int png_effort;           ///< 1 fast to 9 small
    int quality;              ///< of JPEG and WebP, 1 to 100
    const void* icc_profile;  ///< what the values mean; null: not said
    std::size_t icc_bytes;
    const float* chromaticities;  ///< x and y of red, green, blue and white; null: not said
};

/// Where a picture file's bytes go. What fails there is told there and not to the module: format libraries may end
/// the program when they hear of it.
struct PastosoSink {
    void* target;
    void (*write_at)(void* target, std::uint64_t place, const void* bytes, std::size_t count);
};

/// A picture file that is being written, owned by the module.
struct PastosoWriter;

/// What a picture file says of itself before its pixels. The profile lives as long as the reader.
struct PastosoHead {
    int width, height, channels;
    int alpha_channel;        ///< -1: none
    int is_linear;            ///< 1 where the file says so or holds floats
    int colours_have_alpha;   ///< 1: they are multiplied by it (associated)
    int rows_at_once;         ///< rows are read in multiples of this, but for the last ones
    const void* icc_profile;  ///< null where there is none
    std::size_t icc_bytes;
    int has_chromaticities;
    float chromaticities[8];
    int orientation;                  ///< of EXIF: 1 upright to 8
    double px_per_mm_x, px_per_mm_y;  ///< 0: not said
};

/// A picture file that is being read, owned by the module.
struct PastosoReader;

using PastosoImagesAbi = int();
/// These return 0, or 1 and a sentence's predicate in `error`, for example "is not an image".
using PastosoImagesOpen = int(const PastosoPicture* picture, const PastosoSink* sink,
                              PastosoWriter** writer, char* error, std::size_t capacity);
using PastosoImagesWriteRows = int(PastosoWriter* writer, const void* rows, int count, char* error,
                                   std::size_t capacity);
/// After all rows have been written.
using PastosoImagesFinish = int(PastosoWriter* writer, char* error, std::size_t capacity);
/// Frees the writer, finished or not.
using PastosoImagesClose = void(PastosoWriter* writer);
/// Reads from an open file, which remains the caller's, with the reader of that format and no other
/// (OpenImageIO's name). No more is kept than some libraries need: 1 GiB at most.
using PastosoImagesReadOpen = int(const char* format, int descriptor, PastosoReader** reader,
                                  PastosoHead* head, char* error, std::size_t capacity);
/// The first channels of the next rows, interleaved; integers as 0 to 1.
using PastosoImagesReadRows = int(PastosoReader* reader, int channels, int count, float* rows,
                                  char* error, std::size_t capacity);
/// After all rows have been read: whether the file held them all.
using PastosoImagesReadFinish = int(PastosoReader* reader, char* error, std::size_t capacity);
using PastosoImagesReadClose = void(PastosoReader* reader);

}  // extern "C"
