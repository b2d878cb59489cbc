// The states that Undo and Redo return to. Films share their tiles, so a state costs what was changed
// since.
#pragma once

#include "brush/brush.hpp"
#include "document/layers.hpp"
#include "document/selection.hpp"
#include "film/state.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::document {

/// A painting at one moment, as far as Undo brings it back.
struct Moment {
    film::FilmState film;  ///< of the active layer
    LayerStack layers;
    std::optional<brush::Brush> brush;
    std::string medium;           ///< in hand
    std::uint64_t brush_use = 0;  ///< tells whether the brush was loaded, cleaned or changed since
    brush::Contents taken;        ///< from the tubes until then
    brush::Contents wiped;        ///< off the brush until then
    film::Totals run_off;         ///< over the edges until then
    std::optional<film::FilmState> well{};  ///< none: it was bare
    Selection selection{};
};

/// Bytes of the tiles that `older` holds alone, not shared with `newer`; both of one shape.
std::size_t unshared_bytes(const film::FilmState& older, const film::FilmState& newer);

/// The same of canvas and well together.
std::size_t unshared_bytes(const Moment& older, const Moment& newer);

class History {
  public:
    static constexpr std::size_t kDefaultBudget_bytes = std::size_t{512} << 20;
    static constexpr std::size_t kMostMoments = 500;

    /// The oldest moments are dropped while the tiles they hold alone exceed the budget; 0 keeps
    /// nothing.
    void set_budget(std::size_t bytes);

    /// Keeps the moment before a change. What was undone until now cannot be redone any more.
    void remember(Moment before);

    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }

    /// The moment to return to; `now` is kept for the way back. There is one (can_undo, can_redo).
    Moment step_back(Moment now);
    Moment step_forward(Moment now);

    std::size_t moments() const { return past_.size(); }

  private:
    struct Entry {
        Moment moment;
        std::size_t bytes;  ///< not shared with the next newer moment
    };

    void push(Moment moment);
    void drop_oldest_beyond_budget();

    std::size_t budget_bytes_ = kDefaultBudget_bytes;
    std::size_t past_bytes_ = 0;
    std::deque<Entry> past_;
    std::vector<Moment> future_;
};

}  // namespace pastoso::document
