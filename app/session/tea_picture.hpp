// A picture of a glass of milk tea, traced on a thread of its own while the window shows how it gets
// finer.
#pragma once

#include "session/tea_session.hpp"
#include "shade/render.hpp"
#include "trace/tracer.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace pastoso::session {

struct TeaPictureOrder {
    std::shared_ptr<const TeaMoment> moment;  ///< not null
    trace::Camera camera;
    int width = 800, height = 800;  ///< as trace::TraceSettings
    int samples = 48;               ///< of a pixel, 1 and more
    trace::MilkBody body = trace::MilkBody::Surface;
};

class TeaPicture {
  public:
    struct Progress {
        int samples = 0;
        bool finished = false;  ///< or stopped: nothing more comes, and the noise is taken out
        double seconds = 0.0;
        std::string error{};  ///< why there is no picture; one sentence
    };

    /// Begins at once. `notify` is called on the picture's thread; it must return at once.
    TeaPicture(TeaPictureOrder order, std::function<void()> notify);
    ~TeaPicture();
    TeaPicture(const TeaPicture&) = delete;
    TeaPicture& operator=(const TeaPicture&) = delete;

    /// Ends it with the samples that there are.
    void stop() { stopping_ = true; }

    Progress progress() const;

    /// Linear radiance as far as it is known; null before the first sample.
    std::shared_ptr<const trace::Picture> radiance() const;

    /// The same as a screen shows it.
    std::shared_ptr<const shade::Image8> shown() const;

  private:
    void run();
    void trace();
    void publish(trace::Picture radiance, int samples, bool finished);

    const TeaPictureOrder order_;
    const std::function<void()> notify_;
    const std::chrono::steady_clock::time_point began_;
    std::atomic<bool> stopping_ = false, dropped_ = false;
    mutable std::mutex mutex_;
    Progress progress_;
    std::shared_ptr<const trace::Picture> radiance_;
    std::shared_ptr<const shade::Image8> shown_;
    std::thread thread_;
};

}  // namespace pastoso::session
