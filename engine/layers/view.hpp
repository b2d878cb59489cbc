// Layers seen from above as one film, which looks like all of them together: everything that shows or
// measures a painting looks at one film, however many layers there are.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "layers/clipping.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace pastoso::layers {

/// A layer that is seen, apart from what it lies on.
struct SeenLayer {
    const film::FilmState* film;
    double opacity = 1.0;  ///< of what it does to light; its relief is there in full
    /// The layer that it is clipped to, apart from what that one lies on (layers/clipping.hpp); null:
    /// none. What is hidden of it has no relief.
    const film::FilmState* onto = nullptr;
};

/// `upper` on top of `lower`, which lies on the ground, with all its heights, in one tile:
/// - where the upper layer is opaque and holds wet paint, this is the wet paint of the result; what is
///   wet below shows as strata;
/// - where the upper layer is faded, or wet paint lies bare below it, clear wet paint stands for it, so
///   that it shines;
/// - heights of the surface are the sums of all that lies there.
/// Velocities are not looked at, nor what the upper layer is clipped to.
void lay_tile_over(const SeenLayer& upper, const film::FilmState& lower, int tile,
                   film::FilmState& result);

/// Keeps what it saw, and looks anew only where a layer has changed.
class View {
  public:
    /// The layers from below on a bare support. Tiles that are the same as in the last call are shared
    /// with its result.
    film::FilmState of(const film::FilmState& bare, const std::vector<SeenLayer>& layers,
                       core::ThreadPool& pool);

  private:
    struct Step {
        film::FilmState layer, below, result;  ///< as they were
        double opacity = 1.0;
        std::optional<Clipper> clipper;  ///< of a layer that is clipped
    };

    void look(const SeenLayer& layer, const film::FilmState& below, Step& step, core::ThreadPool& pool);

    std::vector<Step> steps_;
};

}  // namespace pastoso::layers
