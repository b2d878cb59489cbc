// Small pictures of layers, painted on a thread of their own.
#pragma once

#include "core/worker.hpp"
#include "document/layers.hpp"
#include "film/state.hpp"
#include "pigment/bands.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace pastoso::session {

/// Row by row from the top, four bytes a pixel: sRGB and the share of the pixel that paint covers.
struct LayerPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    bool wet = false;  ///< it holds wet paint
};

/// A layer's paint over the ground under even light, its relief left out, as large as fits into a box of
/// that many pixels.
LayerPicture layer_picture(const film::FilmState& layer, const pigment::Bands& ground, int most_width,
                           int most_height);

class LayerPainter {
  public:
    /// Is called on the painter's thread; must return at once.
    using Deliver = std::function<void(document::LayerId layer, const LayerPicture& picture)>;

    /// `tell` hears why a picture is missing.
    LayerPainter(int most_width, int most_height, Deliver deliver, core::Tell tell);

    /// Asks for the picture of a layer, in the order of the calls; only the latest film of a layer is
    /// painted.
    void want(document::LayerId layer, std::shared_ptr<const film::FilmState> film,
              const pigment::Bands& ground);

  private:
    struct Wanted {
        document::LayerId layer = 0;
        std::shared_ptr<const film::FilmState> film;
        pigment::Bands ground{};
    };

    core::Worker<Wanted> worker_;
};

}  // namespace pastoso::session
