// The narrow waist between the program and the module that reads and writes image files. The module
// links OpenImageIO, which loads hundreds of libraries; it is opened when the first image is read or
// written.
#pragma once

#include <cstddef>

extern "C" {

/// Raised whenever a declaration below changes; a module of another number is refused.
inline constexpr int kPastosoImagesAbi = 7;

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

/// A picture file that is being written, owned by the module.
struct PastosoWriter;

/// A picture file, allocated by the module.
struct PastosoFile {
    char* bytes;
    std::size_t count;
};

/// One value a pixel, allocated by the module.
struct PastosoGrey {
    float* values;
    int width, height;
};

/// Three values a pixel as they stand in the file (integers as 0 to 1), allocated by the module.
struct PastosoColours {
    float* rgb;
    int width, height;
    int is_linear;      ///< 1 where the file says so or holds floats
    char* icc_profile;  ///< null where there is none
    std::size_t icc_bytes;
    int has_chromaticities;
    float chromaticities[8];
    float* alpha;                     ///< one value a pixel; null where there is none
    int colours_have_alpha;           ///< 1: they are multiplied by it (associated)
    int orientation;                  ///< of EXIF: 1 upright to 8
    double px_per_mm_x, px_per_mm_y;  ///< 0: not said
};

/// Red, green, blue and alpha of each pixel as they stand in the file, not multiplied, allocated by the
/// module.
struct PastosoPixels {
    unsigned char* rgba;
    int width, height;
    char* icc_profile;  ///< null where there is none
    std::size_t icc_bytes;
};

using PastosoImagesAbi = int();
/// These return 0, or 1 and a sentence's predicate in `error`, for example "is not an image".
using PastosoImagesOpen = int(const PastosoPicture* picture, const char* path, PastosoWriter** writer,
                              char* error, std::size_t capacity);
using PastosoImagesWriteRows = int(PastosoWriter* writer, const void* rows, int count, char* error,
                                   std::size_t capacity);
/// After all rows have been written.
using PastosoImagesFinish = int(PastosoWriter* writer, char* error, std::size_t capacity);
/// Frees the writer, finished or not.
using PastosoImagesClose = void(PastosoWriter* writer);
using PastosoImagesEncode = int(const PastosoPicture* picture, const void* rows, PastosoFile* file,
                                char* error, std::size_t capacity);
using PastosoImagesFreeFile = void(PastosoFile* file);
using PastosoImagesReadGrey = int(const char* path, PastosoGrey* grey, char* error,
                                  std::size_t capacity);
using PastosoImagesFree = void(PastosoGrey* grey);
using PastosoImagesReadColours = int(const char* path, PastosoColours* colours, char* error,
                                     std::size_t capacity);
using PastosoImagesFreeColours = void(PastosoColours* colours);
using PastosoImagesDecodePng = int(const void* bytes, std::size_t count, PastosoPixels* pixels,
                                   char* error, std::size_t capacity);
using PastosoImagesFreePixels = void(PastosoPixels* pixels);

}  // extern "C"
