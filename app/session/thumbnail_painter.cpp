#include "session/thumbnail_painter.hpp"

#include "document/thumbnail.hpp"

#include <utility>

namespace pastoso::session {

ThumbnailPainter::ThumbnailPainter(int width_px, int height_px, Deliver deliver, core::Tell tell)
    : worker_(
          [this, width_px, height_px, deliver = std::move(deliver)](Subject& subject) {
              std::visit(
                  [&](const auto& one) {
                      deliver(one.name, document::thumbnail(one, width_px, height_px, pool_));
                  },
                  subject);
          },
          [tell = std::move(tell)](Subject&, const core::Message& fault) { tell(fault); }) {}

void ThumbnailPainter::want(const Subject& subject) {
    worker_.change([&](std::deque<Subject>& waiting) { waiting.push_front(subject); });
}

}  // namespace pastoso::session
