#include "journal/undo_reach.hpp"

namespace pastoso::journal {
namespace {

template <class... Kinds>
bool is_one_of(const document::Action& action) {
    return (std::holds_alternative<Kinds>(action) || ...);
}

bool changes_layers(const document::Action& action) {
    using namespace document;
    return is_one_of<AddLayer, SetLayer, DuplicateLayer, RemoveLayer, ClearLayer, TransformLayer,
                     MoveLayer, MergeDown, FlattenLayers, GroupLayers, SetGroup, MoveGroup,
                     UngroupLayers, PaintPicture>(action);
}

bool lays_picture(const document::Action& action) {
    const auto* lay = std::get_if<document::LayTracing>(&action);
    return lay != nullptr && lay->picture != nullptr;
}

}  // namespace

void UndoReach::note(const document::Action& action) {
    // Cleaning a well that is bare already is no step, nor is changing a selection or a tracing picture
    // that there is not, so these are not counted on.
    if (is_one_of<document::PenDown, document::DryNow, document::SqueezePaint, document::SelectArea,
                  document::SelectByHeight, document::SelectByWetness, document::ResizeCanvas>(action) ||
        changes_layers(action) || lays_picture(action))
        ++undoable_;
    if (changes_painting(action) && !is_one_of<document::Undo, document::Redo>(action)) redoable_ = 0;
    if (is_one_of<document::Undo>(action)) {
        crossed_ = crossed_ || undoable_ == 0;
        --undoable_;
        ++redoable_;
    }
    if (is_one_of<document::Redo>(action)) {
        crossed_ = crossed_ || redoable_ == 0;
        --redoable_;
        ++undoable_;
    }
}

bool changes_painting(const document::Action& action) {
    return changes_layers(action) ||
           is_one_of<document::PenDown, document::DryNow, document::SqueezePaint, document::CleanWell,
                     document::Undo, document::Redo, document::SelectArea, document::SelectByHeight,
                     document::SelectByWetness, document::ResizeCanvas, document::InvertSelection,
                     document::SelectAll, document::LayTracing, document::SetTracing>(action);
}

}  // namespace pastoso::journal
