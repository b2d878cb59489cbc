// Paints the thumbnails of tools on a thread of its own, those that are asked for alone.
#pragma once

#include "brush/preset.hpp"
#include "shade/render.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pastoso::session {

class ThumbnailPainter {
  public:
    /// Is called on the painter's thread; must return at once.
    using Deliver = std::function<void(std::size_t preset, const shade::Image8& image)>;

    ThumbnailPainter(std::vector<brush::Preset> presets, int width_px, int height_px, Deliver deliver);
    /// Waits for the thumbnail under way; what was asked for after it is not painted any more.
    ~ThumbnailPainter();
    ThumbnailPainter(const ThumbnailPainter&) = delete;
    ThumbnailPainter& operator=(const ThumbnailPainter&) = delete;

    /// Asks for the thumbnail of that preset; the latest asked for is painted first.
    void want(std::size_t preset);

  private:
    void run();

    const std::vector<brush::Preset> presets_;
    const int width_px_, height_px_;
    const Deliver deliver_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::size_t> wanted_;
    bool stopping_ = false;
    std::thread thread_;
};

}  // namespace pastoso::session
