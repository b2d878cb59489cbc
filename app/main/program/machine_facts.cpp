#include "main/program/machine_facts.hpp"

#include "appearance/shown_number.hpp"
#include "core/isa.hpp"
#include "core/memory.hpp"
#include "core/thread_count.hpp"
#include "graphics/opengl_support.hpp"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QScreen>
#include <QSysInfo>

namespace pastoso::main {
namespace {

QString tr(const char* words) {
    return QCoreApplication::translate("pastoso::main", words);
}

void add_opengl(Facts& facts) {
    const graphics::OpenGlSupport& opengl = graphics::opengl_support();
    const auto add = [&facts](const QString& what, const std::string& how) {
        facts.emplace_back(what, QString::fromStdString(how));
    };
    if (opengl.renderer.empty()) {
        facts.emplace_back(tr("OpenGL"), tr("none"));
        return;
    }
    const QString renderer = QString::fromStdString(opengl.renderer);
    facts.emplace_back(
        tr("Graphics"),
        opengl.software ? tr("%1 (the processor draws, no graphics card)").arg(renderer) : renderer);
    add(tr("Its maker"), opengl.vendor);
    add(tr("OpenGL"), opengl.version);
    add(tr("Shading language"), opengl.shading_language);
    facts.emplace_back(tr("Largest texture"), tr("%1 pixels a side").arg(opengl.largest_texture));
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
    facts.emplace_back(tr("Free memory"),
                       tr("%1 GB").arg(appearance::shown_number(
                           static_cast<double>(core::available_memory_bytes()) / kGiB, 1)));
    facts.emplace_back(tr("Windows by"), QGuiApplication::platformName());
    facts.emplace_back(tr("Screen"), screen_words());
    add_opengl(facts);
    return facts;
}

}  // namespace pastoso::main
