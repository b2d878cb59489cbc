#include "document/actions/group_actions.hpp"

#include "document/living_painting.hpp"

namespace pastoso::document {

void check_whole(const SetGroup& set) {
    check_group_look(set.look);
}

void apply(const GroupLayers& group, LivingPainting& painting) {
    painting.canvas.group(group);
}

void apply(const SetGroup& set, LivingPainting& painting) {
    painting.canvas.set_group(set);
}

void apply(const MoveGroup& move, LivingPainting& painting) {
    painting.canvas.move_group(move);
}

void apply(const UngroupLayers& ungroup, LivingPainting& painting) {
    painting.canvas.ungroup(ungroup);
}

}  // namespace pastoso::document
