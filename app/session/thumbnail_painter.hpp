// Paints the thumbnails of tools on a thread of its own, those that are asked for alone.
#pragma once

#include "brush/preset.hpp"
#include "core/thread_pool.hpp"
#include "core/worker.hpp"
#include "shade/render.hpp"

#include <functional>
#include <string>

namespace pastoso::session {

class ThumbnailPainter {
  public:
    /// Is called on the painter's thread; must return at once.
    using Deliver = std::function<void(const std::string& preset, const pigment::Image8& image)>;

    /// `tell` hears why a thumbnail is missing. Its end waits for the thumbnail under way; what was
    /// asked for after it is not painted any more.
    ThumbnailPainter(int width_px, int height_px, Deliver deliver, core::Tell tell);

    /// Asks for the thumbnail of a preset; the latest asked for is painted first.
    void want(const brush::Preset& preset);

    /// Paints nothing more of what was asked for so far.
    void forget() { worker_.drop(); }

  private:
    core::ThreadPool pool_{1};
    core::Worker<brush::Preset> worker_;
};

}  // namespace pastoso::session
