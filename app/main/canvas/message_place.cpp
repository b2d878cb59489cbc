#include "main/canvas/message_place.hpp"

#include "panels/messages/message_bar.hpp"

#include <QEvent>
#include <QMainWindow>

namespace pastoso::main {

MessagePlace::MessagePlace(Studio& studio)
    : studio_(studio), bar_(new panels::MessageBar(studio.messages(), &studio.window())) {
    bar_->installEventFilter(this);
    studio_.canvas().installEventFilter(this);
    studio_.canvas().parentWidget()->installEventFilter(this);
    place();
}

bool MessagePlace::eventFilter(QObject* object, QEvent* event) {
    switch (event->type()) {
        case QEvent::Resize:
        case QEvent::Move:
        case QEvent::Show:
        case QEvent::Hide:
            if (object != bar_) place();
            Q_EMIT free_canvas_changed();
            break;
        case QEvent::ZOrderChange:
            if (object != bar_) bar_->raise();
            break;
        default:
            break;
    }
    return QObject::eventFilter(object, event);
}

QRect MessagePlace::free_canvas() const {
    QRect free = studio_.canvas().geometry();
    if (bar_->isHidden()) return free;
    const QPoint top = bar_->mapTo(&studio_.window(), QPoint(0, 0));
    free.setBottom(studio_.canvas().parentWidget()->mapFrom(&studio_.window(), top).y() - 1);
    return free;
}

/// A canvas that has just been taken out of the window leaves the bar where it is.
void MessagePlace::place() {
    const QWidget& canvas = studio_.canvas();
    if (!studio_.window().isAncestorOf(&canvas)) return;
    const QWidget& around = *canvas.parentWidget();
    const QRect inside = canvas.isHidden() ? around.rect() : canvas.geometry();
    bar_->lie_on(inside.translated(around.mapTo(&studio_.window(), QPoint(0, 0))));
}

}  // namespace pastoso::main
