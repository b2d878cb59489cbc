#include "session/repainter.hpp"

#include "core/thread_pool.hpp"

#include <utility>

namespace pastoso::session {
namespace {

/// A tenth of a processor beside a thread that wants all of it, and whatever nobody wants.
constexpr int kNice = 10;

constexpr auto kBetweenPictures = std::chrono::milliseconds(500);

}  // namespace

Repainter::Repainter(document::Recording strokes, std::string name, Notify notify)
    : strokes_(std::move(strokes)), name_(std::move(name)), notify_(std::move(notify)) {
    thread_ = core::Thread([this] { run(); }, [this](const core::Message& fault) { fail(fault); });
}

Repainter::~Repainter() {
    cancel();
    thread_.join();
}

void Repainter::cancel() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
}

void Repainter::set_paused(bool paused) {
    {
        const std::lock_guard lock(mutex_);
        status_.paused = paused;
    }
    changed_.notify_all();
}

Repainter::Status Repainter::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

std::shared_ptr<const document::Snapshot> Repainter::snapshot() const {
    const std::lock_guard lock(mutex_);
    return snapshot_;
}

std::shared_ptr<const project::Project> Repainter::painted() const {
    const std::lock_guard lock(mutex_);
    return painted_;
}

void Repainter::run() {
    core::lower_priority(kNice);
    core::ThreadPool pool;
    counted_at_ = Clock::now();
    std::optional<project::Project> painted = project::repaint(
        strokes_, name_, pool, [this](double done) { return goes_on(done); },
        [this](const document::Painting& painting) {
            if (Clock::now() - published_at_ >= kBetweenPictures) publish(painting);
        });
    if (!painted) return;
    publish(document::Painting(painted->painting, pool));
    {
        const std::lock_guard lock(mutex_);
        status_.done = 1.0;
        painted_ = std::make_shared<const project::Project>(*std::move(painted));
    }
    tell();
}

void Repainter::fail(const core::Message& sentence) {
    {
        const std::lock_guard lock(mutex_);
        status_.error = sentence;
    }
    tell();
}

void Repainter::tell() {
    const std::lock_guard lock(mutex_);
    if (!stopping_) notify_();
}

/// Waits while it is paused.
bool Repainter::goes_on(double done) {
    std::unique_lock lock(mutex_);
    status_.done = done;
    status_.spent_s += std::chrono::duration<double>(Clock::now() - counted_at_).count();
    changed_.wait(lock, [this] { return !status_.paused || stopping_; });
    counted_at_ = Clock::now();
    return !stopping_;
}

void Repainter::publish(const document::Painting& painting) {
    auto snapshot = std::make_shared<const document::Snapshot>(painting.snapshot());
    {
        const std::lock_guard lock(mutex_);
        snapshot_ = std::move(snapshot);
    }
    published_at_ = Clock::now();
    tell();
}

}  // namespace pastoso::session
