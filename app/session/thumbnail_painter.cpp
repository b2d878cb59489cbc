#include "session/thumbnail_painter.hpp"

#include "core/thread_pool.hpp"
#include "document/thumbnail.hpp"

#include <utility>

namespace pastoso::session {

ThumbnailPainter::ThumbnailPainter(int width_px, int height_px, Deliver deliver)
    : width_px_(width_px),
      height_px_(height_px),
      deliver_(std::move(deliver)),
      thread_([this] { run(); }) {}

ThumbnailPainter::~ThumbnailPainter() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void ThumbnailPainter::want(const brush::Preset& preset) {
    {
        const std::lock_guard lock(mutex_);
        wanted_.push_back(preset);
    }
    changed_.notify_one();
}

void ThumbnailPainter::forget() {
    const std::lock_guard lock(mutex_);
    wanted_.clear();
}

void ThumbnailPainter::run() {
    core::ThreadPool pool(1);
    for (;;) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return stopping_ || !wanted_.empty(); });
        if (stopping_) return;
        const brush::Preset preset = std::move(wanted_.back());
        wanted_.pop_back();
        lock.unlock();
        deliver_(preset.name, document::thumbnail(preset, width_px_, height_px_, pool));
    }
}

}  // namespace pastoso::session
