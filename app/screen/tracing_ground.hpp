// A painting as the window shows it: with the picture that is traced below its paint.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "layers/tracing.hpp"

#include <memory>

namespace pastoso::screen {

using Tracing = std::shared_ptr<const layers::Tracing>;  ///< null: none

/// Keeps what it made of the picture for as long as that lies where it is.
class TracingGround {
  public:
    /// The snapshot with this picture below its paint; itself without one.
    std::shared_ptr<const document::Snapshot> below(
        const std::shared_ptr<const document::Snapshot>& painting, const Tracing& tracing,
        core::ThreadPool& pool);

  private:
    void lay(const Tracing& tracing, const grid::Shape& shape, double cell_mm, core::ThreadPool& pool);

    Tracing laid_;
    layers::PictureCells cells_;
    layers::PictureStrata strata_;
    layers::TracedView view_;
};

}  // namespace pastoso::screen
