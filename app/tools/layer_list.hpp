// Layers as a painter sees them listed: from the uppermost down, those of a group below its name.
#pragma once

#include "document/events.hpp"
#include "document/layers.hpp"

#include <optional>
#include <vector>

namespace pastoso::tools {

/// A row of the list: a layer, or the name of a group.
struct LayerRow {
    document::LayerId layer = 0;  ///< 0: a group
    document::GroupId group = 0;  ///< the group itself; 0 for a layer
    friend bool operator==(const LayerRow&, const LayerRow&) = default;
};

/// A row that is in no group, and what is below it.
struct LayerEntry {
    LayerRow row;
    std::vector<document::LayerId> children{};  ///< a group's layers, from the uppermost
    friend bool operator==(const LayerEntry&, const LayerEntry&) = default;
};

std::vector<LayerEntry> layer_entries(const document::LayerStack& stack);

/// A place between two rows: above row number `row` of a group, or of the list for the group 0; one past
/// the last is the lowest place.
struct LayerGap {
    document::GroupId group = 0;
    int row = 0;
    friend bool operator==(const LayerGap&, const LayerGap&) = default;
};

/// What brings a row there. Nothing where it is there already, or where a group would have to go into a
/// group.
std::optional<document::Action> move_to(const document::LayerStack& stack, const LayerRow& row,
                                        const LayerGap& gap);

/// Where a row gets by one step up or down, into and out of groups; nothing at the end of the list.
std::optional<LayerGap> step_from(const document::LayerStack& stack, const LayerRow& row, bool up);

/// The layers that some rows stand for, a group for all of its own, from the lowest.
std::vector<document::LayerId> layers_in(const document::LayerStack& stack,
                                         const std::vector<LayerRow>& rows);

/// What a layer or a group says of itself. Throws InputError when there is no such one.
document::LayerLook look_of(const document::LayerStack& stack, const LayerRow& row);

/// The action that gives a row that look.
document::Action set_look(const LayerRow& row, const document::LayerLook& look);

}  // namespace pastoso::tools
