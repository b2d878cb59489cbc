// Everything that can happen to a painting, as plain data: the window makes these, recordings keep them,
// a replay applies them again.
#pragma once

#include "document/actions/adjust_actions.hpp"
#include "document/actions/aid_actions.hpp"
#include "document/actions/brush_actions.hpp"
#include "document/actions/canvas_actions.hpp"
#include "document/actions/copy_actions.hpp"
#include "document/actions/fill_actions.hpp"
#include "document/actions/group_actions.hpp"
#include "document/actions/history_actions.hpp"
#include "document/actions/layer_actions.hpp"
#include "document/actions/margin_actions.hpp"
#include "document/actions/masking_actions.hpp"
#include "document/actions/media_actions.hpp"
#include "document/actions/pen_actions.hpp"
#include "document/actions/picture_actions.hpp"
#include "document/actions/reference_actions.hpp"
#include "document/actions/selection_actions.hpp"
#include "document/actions/texture_actions.hpp"
#include "document/actions/well_actions.hpp"

#include <type_traits>
#include <variant>

namespace pastoso::document {

template <class... Families>
struct JoinedActions;
template <class... Actions>
struct JoinedActions<ActionList<Actions...>> {
    using Variant = std::variant<Actions...>;
    /// Calls visit(std::type_identity<A>) for every action A.
    static constexpr void for_each(auto&& visit) { (visit(std::type_identity<Actions>{}), ...); }
};
template <class... First, class... Second, class... Rest>
struct JoinedActions<ActionList<First...>, ActionList<Second...>, Rest...>
    : JoinedActions<ActionList<First..., Second...>, Rest...> {};

using AllActions =
    JoinedActions<BrushActions, MediaActions, CanvasActions, PenActions, WellActions, HistoryActions,
                  AidActions, LayerActions, GroupActions, SelectionActions, MarginActions,
                  MaskingActions, PictureActions, CopyActions, FillActions, TextureActions,
                  ReferenceActions, AdjustActions>;

using Action = AllActions::Variant;

inline const ActionTraits& traits_of(const Action& action) {
    return std::visit([]<class A>(const A&) -> const ActionTraits& { return Table<A>::kTraits; },
                      action);
}

/// The same, of the one action whose role is told by what it says: a tracing that is laid is always a
/// step.
UndoRole undo_role(const Action& action);

/// Whether an action that has been carried out has changed the painting. Of a pen that comes down beside
/// its surface nothing is known yet: Painting::late_strokes() counts it where it does.
bool counts_as_change(const Action& action);

/// Throws InputError for an unknown brush, paint or medium, or for a value that is not finite or outside
/// the range that its table gives. The message names the value and says nothing of where it came from.
void check_action(const Action& action);

/// The same for one pen sample.
void check_sample(const brush::PenSample& sample);

/// Version of the stroke format that can say it.
int version_needed(const Action& action);

}  // namespace pastoso::document
