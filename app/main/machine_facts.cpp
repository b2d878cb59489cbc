#include "main/machine_facts.hpp"

#include "core/isa.hpp"
#include "core/memory.hpp"
#include "core/thread_count.hpp"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScreen>
#include <QSysInfo>

namespace pastoso::main {
namespace {

using Facts = std::vector<std::pair<QString, QString>>;

QString tr(const char* words) {
    return QCoreApplication::translate("pastoso::main", words);
}

QString gl_text(QOpenGLFunctions& gl, GLenum what) {
    return QString::fromUtf8(reinterpret_cast<const char*>(gl.glGetString(what)));
}

/// Mesa's and Google's drawing by the processor.
bool draws_by_processor(const QString& renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) return true;
    return false;
}

void add_opengl(Facts& facts) {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) {
        facts.emplace_back(tr("OpenGL"), tr("none"));
        return;
    }
    QOpenGLFunctions& gl = *context.functions();
    const QString renderer = gl_text(gl, GL_RENDERER);
    GLint largest = 0;
    gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    facts.emplace_back(tr("Graphics"),
                       draws_by_processor(renderer)
                           ? tr("%1 (the processor draws, no graphics card)").arg(renderer)
                           : renderer);
    facts.emplace_back(tr("Its maker"), gl_text(gl, GL_VENDOR));
    facts.emplace_back(tr("OpenGL"), gl_text(gl, GL_VERSION));
    facts.emplace_back(tr("Shading language"), gl_text(gl, GL_SHADING_LANGUAGE_VERSION));
    facts.emplace_back(tr("Largest texture"), tr("%1 pixels a side").arg(largest));
    context.doneCurrent();
}

QString screen_words() {
    const QScreen* screen = QGuiApplication::primaryScreen();
    if (screen == nullptr) return tr("none");
    const QSize size = screen->size() * screen->devicePixelRatio();
    return tr("%1 × %2 pixels, %3 for one of the layout")
        .arg(size.width())
        .arg(size.height())
        .arg(screen->devicePixelRatio());
}

}  // namespace

Facts machine_facts() {
    constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;
    Facts facts;
    facts.emplace_back(tr("Program"), QStringLiteral("Pastoso %1, Qt %2")
                                          .arg(QCoreApplication::applicationVersion(),
                                               QString::fromLatin1(qVersion())));
    facts.emplace_back(tr("System"), QStringLiteral("%1, %2 %3")
                                         .arg(QSysInfo::prettyProductName(), QSysInfo::kernelType(),
                                              QSysInfo::kernelVersion()));
    facts.emplace_back(tr("Processor"), tr("%1 at once, %2, kernels for %3")
                                            .arg(core::processor_count())
                                            .arg(QSysInfo::currentCpuArchitecture(),
                                                 QString::fromLatin1(core::name_of(core::best_isa()))));
    facts.emplace_back(
        tr("Free memory"),
        tr("%1 GiB").arg(static_cast<double>(core::available_memory_bytes()) / kGiB, 0, 'f', 1));
    facts.emplace_back(tr("Windows by"), QGuiApplication::platformName());
    facts.emplace_back(tr("Screen"), screen_words());
    add_opengl(facts);
    return facts;
}

}  // namespace pastoso::main
