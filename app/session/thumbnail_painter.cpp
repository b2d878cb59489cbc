#include "session/thumbnail_painter.hpp"

#include "document/thumbnail.hpp"

#include <utility>

namespace pastoso::session {

ThumbnailPainter::ThumbnailPainter(int width_px, int height_px, Deliver deliver, core::Tell tell)
    : worker_(
          [this, width_px, height_px, deliver = std::move(deliver)](brush::Preset& preset) {
              deliver(preset.name, document::thumbnail(preset, width_px, height_px, pool_));
          },
          [tell = std::move(tell)](brush::Preset&, const std::string& fault) { tell(fault); }) {}

void ThumbnailPainter::want(const brush::Preset& preset) {
    worker_.change([&](std::deque<brush::Preset>& waiting) { waiting.push_front(preset); });
}

}  // namespace pastoso::session
