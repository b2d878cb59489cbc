#include "main/program/display.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <QtGlobal>
namespace pastoso::main {
namespace {

std::string setting(const char* variable) {
    const char* value = std::getenv(variable);
    return std::string(variable) +
           (value == nullptr ? " is not set" : " is \"" + std::string(value) + "\"");
}

[[noreturn]] void leave_without_display() {
    std::fprintf(
        stderr,
        "pastoso: There is no display to open a window on (%s, %s); pastoso-cli paints without one.\n",
        setting("DISPLAY").c_str(), setting("WAYLAND_DISPLAY").c_str());
    std::fflush(nullptr);
    std::_Exit(EXIT_FAILURE);
}

/// Qt warns of every plugin that it cannot use, then gives up with a fatal message.
void wait_for_fatal_message(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type == QtFatalMsg) leave_without_display();
}

}  // namespace

void expect_display() {
    const bool chosen = std::getenv("QT_QPA_PLATFORM") != nullptr;
    const bool any = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
    if (!chosen && !any) leave_without_display();
    qInstallMessageHandler(wait_for_fatal_message);
}

void display_found() {
    qInstallMessageHandler(nullptr);
}

}  // namespace pastoso::main
