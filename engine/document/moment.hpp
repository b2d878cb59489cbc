// A painting at one moment, as far as Undo brings it back, and what it takes to keep many of them.
#pragma once

#include "brush/brush.hpp"
#include "core/background_thread.hpp"
#include "document/canvas.hpp"
#include "document/events.hpp"
#include "document/film_tiles.hpp"
#include "document/layers.hpp"
#include "document/selection.hpp"
#include "document/steps.hpp"
#include "layers/tracing.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::document {

/// Wet paint and which of its tiles moved (film::Solver::awake_tiles).
struct SurfaceMoment {
    film::FilmState film{};
    std::vector<bool> awake{};
};

struct Moment {
    std::shared_ptr<const BareCanvas> bare{};
    SurfaceMoment canvas{};  ///< the active layer, on what is visible below it
    LayerStack layers = single_layer();
    std::optional<SurfaceMoment> well{};  ///< none: it was bare
    std::optional<brush::Brush> brush{};
    UseMedium medium{};  ///< in hand
    Selection selection{};
    std::shared_ptr<const layers::Tracing> tracing{};
    TiltCanvas tilt{};
    std::uint64_t brush_use = 0;  ///< tells whether the brush was loaded, cleaned or changed since
    brush::Contents taken{};      ///< from the tubes until then
    brush::Contents wiped{};      ///< off the brush until then
    film::Totals run_off{};       ///< over the edges until then
    Step step{};  ///< that leads to the next moment, in the direction that goes on from here
};

/// A moment told by what differs from a newer one.
class MomentDifference {
  public:
    MomentDifference(const Moment& older, const Moment& newer);

    /// Makes the older moment of the newer one. Any thread may do so.
    Moment applied_to(const Moment& newer) const;

    /// As it was taken, without packing.
    std::size_t bytes() const { return bytes_; }
    const Step& step() const { return rest_.step; }

    /// Has the tiles packed as soon as there is time; once is enough.
    void pack_on(core::BackgroundThread& thread);
    /// Packs them at once, unless they are; the same bytes either way. They stand unpacked as well.
    void pack();
    bool is_unpacked() const;
    /// Keeps what is packed alone, if it is packed.
    void give_up_unpacked();
    /// None: not packed yet.
    std::optional<std::size_t> packed_bytes() const;

  private:
    struct Tiles;

    Moment rest_;  ///< all but the tiles
    grid::Shape shape_;
    std::size_t rest_bytes_ = 0, bytes_ = 0;
    bool packing_ = false;
    std::shared_ptr<Tiles> tiles_;  ///< shared with the thread that packs them
};

}  // namespace pastoso::document
