#include "journal/undo_reach.hpp"

namespace pastoso::journal {

void UndoReach::note(const document::Action& action) {
    using document::UndoRole;
    const UndoRole role = document::undo_role(action);
    // What may change nothing may be no step, and is not counted on.
    if (role == UndoRole::Step) ++undoable_;
    if (role == UndoRole::Undo) {
        crossed_ = crossed_ || undoable_ == 0;
        --undoable_;
        ++redoable_;
    } else if (role == UndoRole::Redo) {
        crossed_ = crossed_ || redoable_ == 0;
        --redoable_;
        ++undoable_;
    } else if (document::traits_of(action).changes_painting) {
        redoable_ = 0;
    }
}

}  // namespace pastoso::journal
