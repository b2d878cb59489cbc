// A small picture of the whole canvas that follows the paint, painted on a thread of its own.
#pragma once

#include "core/worker.hpp"
#include "film/state.hpp"
#include "pigment/viewing.hpp"
#include "session/small_picture.hpp"
#include "shade/render.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace pastoso::session {

/// What a picture of the canvas shows: its paint under even light, the relief left out.
struct OverviewSubject {
    std::shared_ptr<const film::FilmState> film;
    pigment::Bands ground{};
    pigment::Viewing viewing{};
    std::vector<int> tiles;  ///< that have changed since the subject before
};

class Overview {
  public:
    /// As large as fits into a box of that many pixels.
    Overview(int most_width, int most_height) : most_width_(most_width), most_height_(most_height) {}

    /// Paints again what the changed tiles show; all of it where canvas or viewing are others.
    const pigment::Image8& update(const OverviewSubject& subject);

  private:
    bool begin(const OverviewSubject& subject);

    int most_width_, most_height_;
    grid::Shape canvas_;
    pigment::Viewing viewing_;
    pigment::Image8 picture_;
};

class OverviewPainter {
  public:
    /// Is called on the painter's thread; must return at once.
    using Deliver = std::function<void(const pigment::Image8& picture)>;

    /// `tell` hears why there is no picture.
    OverviewPainter(int most_width, int most_height, Deliver deliver, core::Tell tell);

    /// Asks for the picture; one that is asked for before the last is painted takes its place, with
    /// the tiles of both.
    void want(OverviewSubject subject);

  private:
    Overview overview_;
    core::Worker<OverviewSubject> worker_;
};

}  // namespace pastoso::session
