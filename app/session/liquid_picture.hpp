// A picture of a glass of milk tea or a tank of liquid, traced on a thread of its own while the window
// shows how it gets finer.
#pragma once

#include "core/worker.hpp"
#include "pigment/image.hpp"
#include "session/tank_session.hpp"
#include "session/tea_session.hpp"
#include "trace/tea_scene.hpp"
#include "trace/tracer.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace pastoso::session {

struct LiquidPictureOrder {
    /// What is seen; called once, on the picture's thread. What it throws is told.
    std::function<trace::Scene(core::ThreadPool&, trace::MilkBody)> scene;
    int width = 800, height = 800;  ///< as trace::TraceSettings
    int samples = 48;               ///< of a pixel, 1 and more
    trace::MilkBody body = trace::MilkBody::Medium;
};

class LiquidPicture {
  public:
    struct Progress {
        int samples = 0;
        bool finished = false;  ///< or stopped: nothing more comes, and the noise is taken out
        double seconds = 0.0;
        core::Message error{};  ///< why there is no picture; one sentence
    };

    /// Begins at once. `notify` is called on the picture's thread; it must return at once.
    LiquidPicture(LiquidPictureOrder order, std::function<void()> notify);

    /// Ends it with the samples that there are.
    void stop() { stopping_ = true; }

    Progress progress() const;

    /// Linear radiance as far as it is known; null before the first sample.
    std::shared_ptr<const trace::Picture> radiance() const;

    /// The same as a screen shows it.
    std::shared_ptr<const pigment::Image8> shown() const;

  private:
    void trace(const LiquidPictureOrder& order);
    void publish(trace::Picture radiance, int samples, bool finished);
    void fail(const core::Message& sentence);

    const std::function<void()> notify_;
    const std::chrono::steady_clock::time_point began_;
    std::atomic<bool> stopping_ = false;
    mutable std::mutex mutex_;
    Progress progress_;
    std::shared_ptr<const trace::Picture> radiance_;
    std::shared_ptr<const pigment::Image8> shown_;
    core::Worker<LiquidPictureOrder> worker_;
};

/// The glass at one moment.
trace::Scene traced_tea(const TeaSnapshot& snapshot, const trace::Camera& camera, trace::MilkBody body,
                        core::ThreadPool& pool);

/// The tank at one moment, as trace::tank_scene() draws it. The camera stands in the tank's own metres.
trace::Scene traced_tank(const TankSnapshot& snapshot, const trace::Camera& camera,
                         core::ThreadPool& pool);

}  // namespace pastoso::session
