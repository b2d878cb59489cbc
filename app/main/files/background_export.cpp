#include "main/files/background_export.hpp"

#include "appearance/shown_message.hpp"
#include "main/studio.hpp"

#include <utility>

namespace pastoso::main {

BackgroundExport::BackgroundExport(Studio& studio)
    : studio_(studio),
      worker_([this](Write& write) { end(write([this] { return worker_.cancelled(); })); },
              [this](Write&, const core::Message& fault) { end(appearance::shown_message(fault)); }) {}

void BackgroundExport::start(Write write) {
    if (busy()) return studio_.report(tr("A file is being written already. Try again in a moment."));
    busy_ = true;
    worker_.add(std::move(write));
}

void BackgroundExport::end(const QString& told) {
    QMetaObject::invokeMethod(
        this,
        [this, told] {
            busy_ = false;
            studio_.report_refusal(told);
        },
        Qt::QueuedConnection);
}

}  // namespace pastoso::main
