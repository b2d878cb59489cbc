#include "main/queued_refresh.hpp"

#include <atomic>
#include <memory>
#include <utility>

#include <QObject>

namespace pastoso::main {

std::function<void()> queued_refresh(QObject* receiver, std::function<void()> refresh) {
    auto pending = std::make_shared<std::atomic<bool>>(false);
    return [receiver, refresh = std::move(refresh), pending] {
        if (pending->exchange(true)) return;
        QMetaObject::invokeMethod(
            receiver,
            [refresh, pending] {
                pending->store(false);
                refresh();
            },
            Qt::QueuedConnection);
    };
}

}  // namespace pastoso::main
