#include "appearance/focus_loop.hpp"

#include <QWidget>

namespace pastoso::appearance {
namespace {

bool takes_keys(const QWidget& part, const QWidget& widget) {
    return part.isAncestorOf(&widget) && widget.isVisibleTo(&part) && widget.isEnabled() &&
           (widget.focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
}

}  // namespace

bool focus_within(QWidget& part, bool next) {
    QWidget* const from = part.focusWidget() ? part.focusWidget() : &part;
    QWidget* widget = from;
    do
        widget = next ? widget->nextInFocusChain() : widget->previousInFocusChain();
    while (widget != from && !takes_keys(part, *widget));
    if (!takes_keys(part, *widget)) return false;
    widget->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return true;
}

}  // namespace pastoso::appearance
