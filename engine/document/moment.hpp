// A painting at one moment, as far as Undo brings it back, and what it takes to keep many of them.
#pragma once

#include "core/background_thread.hpp"
#include "document/film_tiles.hpp"
#include "document/painting_value.hpp"
#include "document/undo_step.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pastoso::document {

struct Moment {
    PaintingValue value{};
    /// Which tiles moved (film::Solver::awake_tiles()), of the canvas and of the well.
    std::vector<bool> awake{}, well_awake{};
    film::Totals run_off{};  ///< over the edges until then
    UndoStep step{};         ///< that leads to the next moment, in the direction that goes on from here
};

/// What a canvas is divided into.
struct CanvasCells {
    grid::Shape shape;
    double cell_mm = 0.0;
    friend bool operator==(const CanvasCells&, const CanvasCells&) = default;
};

/// A moment told by what differs from a newer one.
class MomentDifference {
  public:
    MomentDifference(const Moment& older, const Moment& newer);

    /// Makes the older moment of the newer one. Any thread may do so.
    Moment applied_to(const Moment& newer) const;

    /// As it was taken, without packing.
    std::size_t bytes() const { return bytes_; }
    const UndoStep& step() const { return rest_.step; }

    /// Has the tiles packed as soon as there is time; once is enough.
    void pack_on(core::BackgroundThread& thread);
    /// Packs them at once, unless they are; the same bytes either way. They stand unpacked as well.
    void pack();
    bool is_unpacked() const;
    /// Keeps what is packed alone, if it is packed.
    void drop_unpacked();
    /// None: not packed yet.
    std::optional<std::size_t> packed_bytes() const;

  private:
    struct Tiles;

    Moment rest_;  ///< all but the tiles
    CanvasCells cells_;
    std::size_t rest_bytes_ = 0, bytes_ = 0;
    bool packing_ = false;
    std::shared_ptr<Tiles> tiles_;  ///< shared with the thread that packs them
};

}  // namespace pastoso::document
