// Paints samples of a tool on a thread of its own, the latest that is asked for alone.
#pragma once

#include "brush/preset.hpp"
#include "core/thread_pool.hpp"
#include "core/worker.hpp"
#include "document/tool_sample.hpp"

#include <functional>

namespace pastoso::session {

class SamplePainter {
  public:
    struct Job {
        brush::Preset preset;
        document::ToolMark mark{};
        document::SampleBoard::Size board;
        int number = 0;  ///< by which whoever asked knows it again
    };

    /// Is called on the painter's thread; must return at once.
    using Deliver = std::function<void(int number, const pigment::Image8& image)>;

    /// `tell` hears why a sample is missing. Its end waits for the tick that the sample under way is at.
    SamplePainter(Deliver deliver, core::Tell tell);

    /// Takes the place of what waits to be painted; what is under way is delivered first.
    void want(Job job) { worker_.replace(std::move(job)); }

    /// Nothing of what was asked for so far is delivered any more, but for what is finished just now.
    void cancel() { worker_.cancel(); }

  private:
    core::ThreadPool pool_{1};
    core::Worker<Job> worker_;
};

}  // namespace pastoso::session
