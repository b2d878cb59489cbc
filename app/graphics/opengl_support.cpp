#include "graphics/opengl_support.hpp"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScreen>
#include <QString>
#include <QSurfaceFormat>

namespace pastoso::graphics {
namespace {

constexpr int kDeepBits = 10;

std::string text(QOpenGLFunctions& gl, GLenum what) {
    const auto* words = reinterpret_cast<const char*>(gl.glGetString(what));
    return words == nullptr ? "" : words;
}

/// Mesa's and Google's drawing by the processor.
bool is_software(const std::string& renderer) {
    const QString name = QString::fromStdString(renderer);
    for (const char* known : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        if (name.contains(QLatin1String(known), Qt::CaseInsensitive)) return true;
    return false;
}

OpenGlSupport found_support() {
    OpenGlSupport found;
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) {
        found.problem = "This display offers no OpenGL.";
        return found;
    }
    const auto [major, minor] = context.format().version();
    if (major * 10 + minor < 33) {
        found.problem = "This display offers OpenGL " + std::to_string(major) + "." +
                        std::to_string(minor) + ", where 3.3 is needed.";
    }
    QOpenGLFunctions& gl = *context.functions();
    found.renderer = text(gl, GL_RENDERER);
    found.vendor = text(gl, GL_VENDOR);
    found.version = text(gl, GL_VERSION);
    found.shading_language = text(gl, GL_SHADING_LANGUAGE_VERSION);
    found.software = is_software(found.renderer);
    gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &found.largest_texture);
    return found;
}

}  // namespace

void ask_for_opengl() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setOption(QSurfaceFormat::ResetNotification);
    QSurfaceFormat::setDefaultFormat(format);
}

void ask_for_deep_colour() {
    const bool x11 = QGuiApplication::platformName() == QLatin1String("xcb");
    if (x11 && QGuiApplication::primaryScreen()->depth() < 30) return;
    QSurfaceFormat format = QSurfaceFormat::defaultFormat();
    format.setRedBufferSize(kDeepBits);
    format.setGreenBufferSize(kDeepBits);
    format.setBlueBufferSize(kDeepBits);
    QOpenGLContext context;
    context.setFormat(format);
    if (context.create() && context.format().redBufferSize() >= kDeepBits)
        QSurfaceFormat::setDefaultFormat(format);
}

bool deep_colour() {
    return QSurfaceFormat::defaultFormat().redBufferSize() >= kDeepBits;
}

const OpenGlSupport& opengl_support() {
    static const OpenGlSupport support = found_support();
    return support;
}

}  // namespace pastoso::graphics
