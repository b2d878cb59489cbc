#include "app/gl_faults.hpp"

#include <cstring>
#include <dlfcn.h>
#include <utility>

#include <QOpenGLFunctions>

namespace pastoso::tests {
namespace {

using Function = void (*)();
using FindFunction = Function (*)(const unsigned char*);

GLenum pending_error = GL_NO_ERROR;

FindFunction driver() {
    static const auto find =
        reinterpret_cast<FindFunction>(dlsym(dlopen("libGL.so.1", RTLD_LAZY), "glXGetProcAddress"));
    return find;
}

template <class F>
F of_driver(const char* name) {
    return reinterpret_cast<F>(driver()(reinterpret_cast<const unsigned char*>(name)));
}

void get_integer(GLenum what, GLint* value) {
    static const auto real = of_driver<void (*)(GLenum, GLint*)>("glGetIntegerv");
    real(what, value);
    if (what == GL_MAX_TEXTURE_SIZE && gl_faults().largest_texture > 0)
        *value = gl_faults().largest_texture;
}

void make_texture(GLenum target, GLint level, GLint format, GLsizei width, GLsizei height, GLsizei depth,
                  GLint border, GLenum texels, GLenum type, const void* values) {
    using Make =
        void (*)(GLenum, GLint, GLint, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*);
    static const auto real = of_driver<Make>("glTexImage3D");
    if (gl_faults().out_of_memory)
        pending_error = GL_OUT_OF_MEMORY;
    else
        real(target, level, format, width, height, depth, border, texels, type, values);
}

GLenum get_error() {
    static const auto real = of_driver<GLenum (*)()>("glGetError");
    if (gl_faults().reset) return GL_CONTEXT_LOST;
    const GLenum pending = std::exchange(pending_error, GL_NO_ERROR);
    return pending != GL_NO_ERROR ? pending : real();
}

}  // namespace

GlFaults& gl_faults() {
    static GlFaults faults;
    return faults;
}

}  // namespace pastoso::tests

extern "C" __attribute__((visibility("default"))) pastoso::tests::Function glXGetProcAddress(
    const unsigned char* name) {
    using namespace pastoso::tests;
    const std::pair<const char*, Function> ours[] = {
        {"glGetIntegerv", reinterpret_cast<Function>(get_integer)},
        {"glTexImage3D", reinterpret_cast<Function>(make_texture)},
        {"glGetError", reinterpret_cast<Function>(get_error)}};
    for (const auto& [wrapped, function] : ours)
        if (std::strcmp(reinterpret_cast<const char*>(name), wrapped) == 0) return function;
    return driver()(name);
}
