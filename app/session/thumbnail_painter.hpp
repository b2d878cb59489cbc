// Paints the thumbnails of tools and media on a thread of its own, those that are asked for alone.
#pragma once

#include "brush/preset.hpp"
#include "core/thread_pool.hpp"
#include "core/worker.hpp"
#include "film/medium.hpp"
#include "shade/render.hpp"

#include <functional>
#include <string>
#include <variant>

namespace pastoso::session {

class ThumbnailPainter {
  public:
    using Subject = std::variant<brush::Preset, film::Medium>;

    /// Is called on the painter's thread; must return at once.
    using Deliver = std::function<void(const std::string& name, const pigment::Image8& image)>;

    /// `tell` hears why a thumbnail is missing. Its end waits for the thumbnail under way; what was
    /// asked for after it is not painted any more.
    ThumbnailPainter(int width_px, int height_px, Deliver deliver, core::Tell tell);

    /// Asks for the thumbnail of a preset or a medium; the latest asked for is painted first.
    void want(const Subject& subject);

    /// Paints nothing more of what was asked for so far.
    void forget() { worker_.drop(); }

  private:
    core::ThreadPool pool_{1};
    core::Worker<Subject> worker_;
};

}  // namespace pastoso::session
