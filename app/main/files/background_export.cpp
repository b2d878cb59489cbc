#include "main/files/background_export.hpp"

#include "core/error.hpp"
#include "main/studio.hpp"

#include <utility>

namespace pastoso::main {

BackgroundExport::~BackgroundExport() {
    stops_ = true;
    if (thread_.joinable()) thread_.join();
}

void BackgroundExport::start(std::function<QString(const std::atomic<bool>&)> write) {
    if (busy_) return studio_.report(tr("A surface is being written already. Try again in a moment."));
    if (thread_.joinable()) thread_.join();
    busy_ = true;
    thread_ = std::thread([this, write = std::move(write)] {
        QString told;
        try {
            told = write(stops_);
        } catch (const core::InputError& error) {
            told = QString::fromUtf8(error.what());
        }
        busy_ = false;
        QMetaObject::invokeMethod(
            this, [this, told] { studio_.report_refusal(told); }, Qt::QueuedConnection);
    });
}

}  // namespace pastoso::main
