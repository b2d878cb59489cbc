// Whether Undo and Redo stay on this side of a moment.
#pragma once

#include "document/events.hpp"

namespace pastoso::journal {

/// Follows the actions after a moment. A painting that is loaded at that moment has no past: once Undo
/// or Redo may have reached behind it, replaying the actions from there gives another painting. Errs on
/// the safe side only.
class UndoReach {
  public:
    void note(const document::Action& action);

    bool crossed() const { return crossed_; }

  private:
    int undoable_ = 0, redoable_ = 0;  ///< at least so many steps
    bool crossed_ = false;
};

}  // namespace pastoso::journal
