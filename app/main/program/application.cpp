#include "main/program/application.hpp"

#include "appearance/shown_message.hpp"
#include "core/fault.hpp"
#include "core/printable.hpp"

#include <clocale>
#include <cstdio>

namespace pastoso::main {

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    std::setlocale(LC_NUMERIC, "C");
    // A mouse that moves while the window is busy paints a curve as well, and no corners.
    setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

bool Application::notify(QObject* receiver, QEvent* event) {
    bool is_handled = false;
    core::guarded([&] { is_handled = QApplication::notify(receiver, event); },
                  [this](const core::Message& fault) {
                      std::fprintf(stderr, "pastoso: %s\n", core::printable(fault.text()).c_str());
                      Q_EMIT failed(appearance::shown_message(fault));
                  });
    return is_handled;
}

}  // namespace pastoso::main
