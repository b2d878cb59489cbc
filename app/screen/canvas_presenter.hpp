// Makes what the canvas's textures hold, on threads of its own: the window's only puts it onto the
// graphics card.
#pragma once

#include "core/worker.hpp"
#include "screen/canvas_layers.hpp"
#include "screen/canvas_outlines.hpp"
#include "screen/drawing_threads.hpp"
#include "screen/look_layer.hpp"
#include "screen/tracing_ground.hpp"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::screen {

/// What is to be seen.
struct Sight {
    std::shared_ptr<const document::Snapshot> painting;
    Tracing tracing;  ///< below its paint
    shade::Lighting lighting;
    pigment::Viewing viewing;
    Look look = Look::Lit;
    friend bool operator==(const Sight&, const Sight&) = default;
};

/// What of the textures has changed since the presentation before.
struct Presentation {
    Sight sight;                                     ///< they hold this one then
    std::shared_ptr<const document::Snapshot> seen;  ///< its painting on what is traced
    bool begins = false;                             ///< they held nothing of this canvas before
    bool recoloured = false;                         ///< all colours are others
    std::vector<int> tiles;                          ///< whose paint is another
    std::vector<SurfacePatch> surface;
    std::vector<ColourPatch> colours;
    std::vector<LookPatch> look;
    std::vector<OutlinePatch> outlines;
    grid::Rect outlined;  ///< cells of which all outlines are there then
    core::Message fault;  ///< in one sentence, instead of all of it
};

/// All calls come from one thread, but for what it calls itself.
class CanvasPresenter {
  public:
    /// `ready` is called on another thread when take() has something.
    explicit CanvasPresenter(std::function<void()> ready);

    /// Begins to make the next presentation; `begins`: of textures that hold nothing; with the outlines
    /// of so many cells. Not while it is busy.
    void make(Sight sight, bool begins, const grid::Rect& outlined);

    /// Until what was begun has been taken.
    bool busy() const { return busy_; }

    /// The presentation, once it is ready; of one that is under way, so long is waited for it.
    std::optional<Presentation> take(std::chrono::microseconds patience);

  private:
    struct Job {
        Sight sight;
        bool begins;
        grid::Rect outlined;
    };

    void present(const Job& job);
    void add_relief(Presentation& next);
    void add_colours(Presentation& next);
    void add_look(Presentation& next);
    void add_outlines(Presentation& next);
    void hand_over(Presentation presentation);

    std::function<void()> ready_;
    bool busy_ = false;
    core::ThreadPool& pool_ = drawing_threads();
    CanvasLayers layers_;
    CanvasOutlines outlines_;
    TracingGround ground_;
    std::optional<Sight> made_;
    std::shared_ptr<const document::Snapshot> made_seen_;
    std::mutex mutex_;
    std::condition_variable is_made_;
    std::optional<Presentation> made_presentation_;
    core::Worker<Job> worker_;  ///< the last: it ends before what it works with
};

}  // namespace pastoso::screen
