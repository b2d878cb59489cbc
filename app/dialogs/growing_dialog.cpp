#include "dialogs/growing_dialog.hpp"

#include <QEvent>
#include <QLayout>

namespace pastoso::dialogs {

bool GrowingDialog::event(QEvent* event) {
    const bool handled = QDialog::event(event);
    const bool may_need_more = event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show;
    if (!may_need_more || layout() == nullptr) return handled;
    const int needed =
        layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : sizeHint().height();
    if (needed > height()) resize(width(), needed);
    return handled;
}

}  // namespace pastoso::dialogs
