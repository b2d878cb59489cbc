#include "document/actions/history_actions.hpp"

#include "document/living_painting.hpp"

namespace pastoso::document {

void apply(const Undo&, LivingPainting& painting) {
    if (painting.history.can_undo()) painting.return_to(painting.history.step_back(painting.moment()));
}

void apply(const Redo&, LivingPainting& painting) {
    if (painting.history.can_redo())
        painting.return_to(painting.history.step_forward(painting.moment()));
}

}  // namespace pastoso::document
