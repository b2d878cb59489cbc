// The order in which every action is carried out.
#pragma once

#include "document/actions/table.hpp"
#include "document/living_painting.hpp"

#include <type_traits>
#include <utility>

namespace pastoso::document {

/// The name of an action's undo step, with the layer or group that it is about. Throws InputError when
/// there is none of that number.
template <class A>
UndoStep step_of(const A& action, const LivingPainting& painting) {
    UndoStep step{.name = Table<A>::kTraits.step};
    if constexpr (requires { undo_step(action, painting); })
        step = undo_step(action, painting);
    else if constexpr (requires { action.layer; })
        step.layer =
            painting.value.layers.layers[place_of(painting.value.layers, action.layer)].look.name;
    else if constexpr (requires { action.group; })
        step.layer = group_of(painting.value.layers, action.group).look.name;
    else if constexpr (requires { action.name; })
        step.layer = action.name;
    return step;
}

template <class A>
void carry_out(const A& action, LivingPainting& painting) {
    if constexpr (requires { apply(action, painting); })
        apply(action, painting);
    else
        put_in_hand(action, painting.value);
}

template <class A>
bool begins_beside(const A& action) {
    if constexpr (requires { action.beside; })
        return action.beside;
    else
        return false;
}

/// Whether it is part of the step of another one of its kind, right before it.
template <class A>
bool joins_latest(const A& action, const UndoStep& step, const ActionTraits* before, History& history) {
    if constexpr (requires { action.joins; })
        return action.joins && before == &Table<A>::kTraits && history.join_latest(step);
    else
        return false;
}

/// An action that has passed check_action(). What cannot be done throws InputError and leaves the
/// painting as it was, but for a stroke that ends.
template <class A>
void perform(const A& action, LivingPainting& painting) {
    constexpr ActionTraits kTraits = Table<A>::kTraits;
    constexpr bool kIsStep = kTraits.undo == UndoRole::Step || kTraits.undo == UndoRole::MaybeStep;
    static_assert(!kIsStep || kTraits.stroke != StrokeRole::GoesOn, "a moment lies between two strokes");
    if constexpr (kTraits.stroke == StrokeRole::Ends && kTraits.undo == UndoRole::MaybeStep)
        painting.end_stroke();
    if constexpr (kTraits.undo == UndoRole::MaybeStep)
        if (!changes_anything(action, painting)) return;
    if constexpr (requires { check_possible(action, painting); }) check_possible(action, painting);
    if constexpr (!kIsStep) {
        if constexpr (kTraits.stroke == StrokeRole::Ends) painting.end_stroke();
        carry_out(action, painting);
    } else {
        UndoStep step = step_of(action, painting);
        painting.end_stroke();
        Moment before = painting.moment();
        // Whether it changes anything only the stroke that it begins can tell.
        if (begins_beside(action)) {
            painting.awaited_step = {std::move(before), std::move(step)};
            apply(action, painting);
        } else {
            apply(action, painting);
            if (!joins_latest(action, step, painting.latest, painting.history))
                painting.history.remember(std::move(before), std::move(step));
        }
    }
    painting.latest = &Table<A>::kTraits;
}

}  // namespace pastoso::document
