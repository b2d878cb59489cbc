#include "main/program/application.hpp"

#include "appearance/shown_message.hpp"
#include "core/fault.hpp"
#include "core/printable.hpp"

#include <clocale>
#include <cstdio>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QWidget>

namespace pastoso::main {
namespace {

/// Of what no widget has taken: keyboards without a Menu key have these two instead, of which the
/// window system tells nothing more.
bool asks_for_menu(const QEvent& event) {
    if (event.type() != QEvent::KeyPress || event.isAccepted()) return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.key() == Qt::Key_F10 && key.modifiers() == Qt::ShiftModifier;
}

/// Where its cursor or its current entry is, as by the Menu key.
void open_menu_of(QWidget& widget) {
    const QPoint place = widget.inputMethodQuery(Qt::ImCursorRectangle).toRect().center();
    QContextMenuEvent wanted(QContextMenuEvent::Keyboard, place, widget.mapToGlobal(place));
    QCoreApplication::sendEvent(&widget, &wanted);
}

}  // namespace

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    std::setlocale(LC_NUMERIC, "C");
    // A mouse that moves while the window is busy paints a curve as well, and no corners.
    setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

bool Application::notify(QObject* receiver, QEvent* event) {
    bool is_handled = false;
    const auto handle = [&] {
        is_handled = QApplication::notify(receiver, event);
        auto* widget = asks_for_menu(*event) ? qobject_cast<QWidget*>(receiver) : nullptr;
        if (widget == nullptr) return;
        is_handled = true;
        event->accept();
        open_menu_of(*widget);
    };
    core::guarded(handle, [this](const core::Message& fault) {
        std::fprintf(stderr, "pastoso: %s\n", core::printable(fault.text()).c_str());
        Q_EMIT failed(appearance::shown_message(fault));
    });
    return is_handled;
}

}  // namespace pastoso::main
