// The states that Undo and Redo return to (docs/decisions/0028-packed-history.md).
#pragma once

#include "core/background_thread.hpp"
#include "document/moment_stack.hpp"

#include <cstddef>
#include <vector>

namespace pastoso::document {

/// A moment costs the tiles that were changed until the next one. The latest steps are kept as they are,
/// in an eighth of the budget; older ones are packed by a thread of low priority, and the
/// oldest are dropped when they take more than the rest. As long as that leaves room in the budget, the
/// latest of the packed ones stay as they are beside it: Undo has nothing to unpack then. What is
/// dropped depends on the moments alone, never on how far the packing has come: where Undo has to know,
/// it packs what is left itself.
class History {
  public:
    static constexpr std::size_t kDefaultBudget_bytes = std::size_t{512} << 20;
    static constexpr std::size_t kMostMoments = 500;

    History() { set_budget(kDefaultBudget_bytes); }

    /// 0 keeps nothing. The moment before the latest change and, after Undo, what Redo returns to come
    /// on top, and so do steps that wait for being packed: up to a quarter of the budget, what is more
    /// is packed at once.
    void set_budget(std::size_t bytes);

    /// Keeps so many steps, whatever memory they take, packed but for the latest. 0 keeps nothing.
    void keep_steps(std::size_t count);

    /// Keeps the moment before a change. What was undone until now cannot be redone any more.
    void remember(Moment before, UndoStep step);

    /// A change belongs to the latest step, whose moment stands, where that has the same name; else it
    /// is to be remembered: false. What was undone until now cannot be redone any more.
    bool join_latest(const UndoStep& step);

    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }

    /// The moment to return to; `now` is kept for the way back. There is one (can_undo, can_redo).
    Moment step_back(Moment now);
    Moment step_forward(Moment now);

    /// What Undo would take back, the oldest first, and what Redo would do again, the next one last.
    std::vector<KeptStep> past_steps() const { return past_.steps(); }
    std::vector<KeptStep> future_steps() const { return future_.steps(); }

    /// Packs at once all that is to be packed.
    void finish_packing();

    /// What all steps take, both ways, but for the ones next in turn.
    std::size_t bytes() const;

  private:
    void set_limits(std::size_t budget_bytes, std::size_t packed_bytes, std::size_t most_moments);
    void drop_oldest();
    void limit_unpacked();

    std::size_t budget_bytes_ = 0;
    std::size_t packed_bytes_ = 0;   ///< that may be kept
    std::size_t waiting_bytes_ = 0;  ///< that may wait for being packed
    std::size_t most_moments_ = kMostMoments;
    core::BackgroundThread packer_;
    MomentStack past_{packer_}, future_{packer_};
};

}  // namespace pastoso::document
