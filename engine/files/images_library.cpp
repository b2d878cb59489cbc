#include "files/images_library.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"

#include <dlfcn.h>
#include <string>

namespace pastoso::files {
namespace {

template <class Function>
Function* find(void* module, const char* name) {
    return reinterpret_cast<Function*>(::dlsym(module, name));
}

ImagesLibrary open_library() {
    const std::string path =
        (core::installed_prefix() / "lib" / "pastoso" / "pastoso-images.so").string();
    void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr)
        throw core::InputError("%1: this part of the program cannot be loaded (%2).", path, ::dlerror());
    auto* const abi = find<PastosoImagesAbi>(module, "pastoso_images_abi");
    if (abi == nullptr || abi() != kPastosoImagesAbi) {
        throw core::InputError("%1: this part of the program is of another version; reinstall it.",
                               path);
    }
    return {find<PastosoImagesOpen>(module, "pastoso_images_open"),
            find<PastosoImagesWriteRows>(module, "pastoso_images_write_rows"),
            find<PastosoImagesFinish>(module, "pastoso_images_finish"),
            find<PastosoImagesClose>(module, "pastoso_images_close"),
            find<PastosoImagesReadOpen>(module, "pastoso_images_read_open"),
            find<PastosoImagesReadRows>(module, "pastoso_images_read_rows"),
            find<PastosoImagesReadFinish>(module, "pastoso_images_read_finish"),
            find<PastosoImagesReadClose>(module, "pastoso_images_read_close")};
}

}  // namespace

const ImagesLibrary& images_library() {
    static const ImagesLibrary library = open_library();
    return library;
}

}  // namespace pastoso::files
