// Opens the image module.
#pragma once

#include "files/images_abi.hpp"

namespace pastoso::files {

struct ImagesLibrary {
    PastosoImagesOpen* open = nullptr;
    PastosoImagesWriteRows* write_rows = nullptr;
    PastosoImagesFinish* finish = nullptr;
    PastosoImagesClose* close = nullptr;
    PastosoImagesReadOpen* read_open = nullptr;
    PastosoImagesReadRows* read_rows = nullptr;
    PastosoImagesReadFinish* read_finish = nullptr;
    PastosoImagesReadClose* read_close = nullptr;
};

/// The module "pastoso-images.so" in lib/pastoso below core::installed_prefix(), opened at the first
/// call and kept. Throws InputError when it is missing or of another version. Safe on any thread.
const ImagesLibrary& images_library();

}  // namespace pastoso::files
