#include "main/program/machine_facts.hpp"

#include "core/isa.hpp"
#include "core/memory.hpp"
#include "core/thread_count.hpp"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QScreen>
#include <QSysInfo>

namespace pastoso::main {
namespace {

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

void add_opengl(QOpenGLWidget& canvas, Facts& facts) {
    if (canvas.context() == nullptr) {
        facts.emplace_back(tr("OpenGL"), tr("none"));
        return;
    }
    canvas.makeCurrent();
    QOpenGLFunctions& gl = *canvas.context()->functions();
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
    canvas.doneCurrent();
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
    return facts;
}

Facts machine_facts(QOpenGLWidget& canvas) {
    Facts facts = machine_facts();
    add_opengl(canvas, facts);
    return facts;
}

QString words_of(const Facts& facts) {
    QString words;
    for (const auto& [what, how] : facts)
        words += QStringLiteral("%1: %2\n").arg(what, how);
    return words;
}

}  // namespace pastoso::main
