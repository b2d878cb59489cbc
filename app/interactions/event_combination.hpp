// How what the pointer chooses is combined with what is selected.
#pragma once

#include "grid/mask.hpp"

#include <Qt>

namespace pastoso::interactions {

/// Shift adds, Alt takes away, both keep what is common.
inline grid::Combination combination(Qt::KeyboardModifiers modifiers) {
    const bool shift = modifiers.testFlag(Qt::ShiftModifier);
    if (modifiers.testFlag(Qt::AltModifier))
        return shift ? grid::Combination::Intersect : grid::Combination::Subtract;
    return shift ? grid::Combination::Add : grid::Combination::Replace;
}

}  // namespace pastoso::interactions
