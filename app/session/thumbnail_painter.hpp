// Paints the thumbnails of tools on a thread of its own, those that are asked for alone.
#pragma once

#include "brush/preset.hpp"
#include "shade/render.hpp"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace pastoso::session {

class ThumbnailPainter {
  public:
    /// Is called on the painter's thread; must return at once.
    using Deliver = std::function<void(const std::string& preset, const shade::Image8& image)>;

    ThumbnailPainter(int width_px, int height_px, Deliver deliver);
    /// Waits for the thumbnail under way; what was asked for after it is not painted any more.
    ~ThumbnailPainter();
    ThumbnailPainter(const ThumbnailPainter&) = delete;
    ThumbnailPainter& operator=(const ThumbnailPainter&) = delete;

    /// Asks for the thumbnail of a preset; the latest asked for is painted first.
    void want(const brush::Preset& preset);

    /// Paints nothing more of what was asked for so far.
    void forget();

  private:
    void run();

    const int width_px_, height_px_;
    const Deliver deliver_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<brush::Preset> wanted_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace pastoso::session
