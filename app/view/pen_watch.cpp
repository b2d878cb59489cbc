#include "view/pen_watch.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>

namespace pastoso::view {

PenWatch::PenWatch(QWidget& over) : over_(over) {
    QCoreApplication::instance()->installEventFilter(this);
}

/// The leaving of a tablet is told to the application alone.
bool PenWatch::eventFilter(QObject* receiver, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool is_elsewhere = (type == QEvent::TabletMove || type == QEvent::TabletPress) &&
                              receiver->isWidgetType() && !is_part(*receiver);
    if (type == QEvent::TabletLeaveProximity || is_elsewhere) Q_EMIT pen_left();
    return false;
}

/// What lies on the widget hands on to it what it does not want itself.
bool PenWatch::is_part(const QObject& receiver) const {
    return &receiver == &over_ || over_.isAncestorOf(static_cast<const QWidget*>(&receiver));
}

}  // namespace pastoso::view
