// The narrow waist between the program and the module that reads and writes image files. The module
// links OpenImageIO, which loads hundreds of libraries; it is opened when the first image is read or
// written.
#pragma once

#include <cstddef>

extern "C" {

/// Raised whenever a declaration below changes; a module of another number is refused.
inline constexpr int kPastosoImagesAbi = 2;

enum PastosoSampleType {
    kPastosoUint8 = 0,
    kPastosoUint16 = 1,
    kPastosoFloat = 2,  ///< stored as halves
    kPastosoData = 3,   ///< floats that are no colours, stored as they are
};

/// Rows from the top without gaps, channels interleaved. Integers are encoded sRGB, floats linear.
struct PastosoPixels {
    const void* data;
    int width, height, channels;
    int sample_type;     ///< PastosoSampleType
    double px_per_mm;    ///< for the file's resolution entry; 0: left out
    const char* format;  ///< OpenImageIO's name of the file format
    const char* software;
};

/// One value a pixel, allocated by the module.
struct PastosoGrey {
    float* values;
    int width, height;
};

using PastosoImagesAbi = int();
/// These return 0, or 1 and a sentence's predicate in `error`, for example "is not an image".
using PastosoImagesWrite = int(const PastosoPixels* pixels, const char* path, char* error,
                               std::size_t capacity);
using PastosoImagesReadGrey = int(const char* path, PastosoGrey* grey, char* error,
                                  std::size_t capacity);
using PastosoImagesFree = void(PastosoGrey* grey);

}  // extern "C"
