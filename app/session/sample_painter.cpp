#include "session/sample_painter.hpp"

#include <string>
#include <utility>

namespace pastoso::session {

SamplePainter::SamplePainter(Deliver deliver, core::Tell tell)
    : worker_(
          [this, deliver = std::move(deliver)](Job& job) {
              const pigment::Image8 image = document::tool_sample(
                  job.preset, job.mark, job.board, pool_, [this] { return worker_.cancelled(); });
              if (!image.rgb.empty()) deliver(job.number, image);
          },
          [tell = std::move(tell)](Job&, const core::Message& fault) { tell(fault); }) {}

}  // namespace pastoso::session
