#include "document/layers.hpp"

#include "core/error.hpp"
#include "document/actions/field_checks.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace pastoso::document {
namespace {

/// Layers of one group lie next to each other.
bool groups_hang_together(const std::vector<Layer>& layers) {
    std::vector<GroupId> ended;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const GroupId group = layers[i].group;
        if (group == 0) continue;
        if (std::find(ended.begin(), ended.end(), group) != ended.end()) return false;
        if (i + 1 == layers.size() || layers[i + 1].group != group) ended.push_back(group);
    }
    return true;
}

/// Takes another order, with the same layer active. Throws `torn` where a group would not hang together.
void reorder(LayerStack& stack, std::vector<Layer> layers, const core::Message& torn) {
    if (!groups_hang_together(layers)) throw core::InputError(torn);
    const LayerId active = stack.layers[stack.active].id;
    stack.layers = std::move(layers);
    stack.active = place_of(stack, active);
    drop_empty_groups(stack);
}

void check_place(int place, std::size_t most) {
    if (place >= 0 && static_cast<std::size_t>(place) <= most) return;
    throw core::InputError("there is no place %1 for a layer; the highest is %2.", place, most);
}

std::size_t place_of_group(const LayerStack& stack, GroupId group) {
    const auto found = std::find_if(stack.groups.begin(), stack.groups.end(),
                                    [&](const LayerGroup& one) { return one.id == group; });
    if (found == stack.groups.end()) throw core::InputError("there is no group %1 of layers.", group);
    return static_cast<std::size_t>(found - stack.groups.begin());
}

}  // namespace

LayerStack single_layer() {
    LayerStack stack;
    stack.layers.push_back({.id = 1, .look = {.name = "Paint"}});
    stack.next_layer = 2;
    return stack;
}

std::size_t place_of(const LayerStack& stack, LayerId layer) {
    const auto found = std::find_if(stack.layers.begin(), stack.layers.end(),
                                    [&](const Layer& one) { return one.id == layer; });
    if (found == stack.layers.end()) throw core::InputError("there is no layer %1.", layer);
    return static_cast<std::size_t>(found - stack.layers.begin());
}

LayerGroup& group_of(LayerStack& stack, GroupId group) {
    return stack.groups[place_of_group(stack, group)];
}

const LayerGroup& group_of(const LayerStack& stack, GroupId group) {
    return stack.groups[place_of_group(stack, group)];
}

std::optional<std::size_t> clipping_base(const LayerStack& stack, std::size_t place) {
    const GroupId group = stack.layers[place].group;
    for (std::size_t below = place; below-- > 0;) {
        const Layer& layer = stack.layers[below];
        if (layer.group == group && !layer.look.clipped) return below;
    }
    return std::nullopt;
}

std::optional<std::size_t> clipped_to(const LayerStack& stack, std::size_t place) {
    return stack.layers[place].look.clipped ? clipping_base(stack, place) : std::nullopt;
}

LayerLook look_in_group(const LayerStack& stack, std::size_t place) {
    LayerLook look = stack.layers[place].look;
    if (const auto onto = clipped_to(stack, place)) {
        const LayerLook& base = stack.layers[*onto].look;
        look.visible = look.visible && base.visible;
        look.opacity *= base.opacity;
    }
    return look;
}

LayerLook effective_look(const LayerStack& stack, std::size_t place) {
    const Layer& layer = stack.layers[place];
    LayerLook look = look_in_group(stack, place);
    for (const LayerGroup& group : stack.groups) {
        if (group.id != layer.group) continue;
        look.visible = look.visible && group.look.visible;
        look.locked = look.locked || group.look.locked;
        look.bare_locked = look.bare_locked || group.look.bare_locked;
        look.opacity *= group.look.opacity;
    }
    return look;
}

bool is_single(const LayerStack& stack) {
    const LayerLook& look = stack.layers.front().look;
    return stack.layers.size() == 1 && stack.groups.empty() && look.visible && !look.locked &&
           !look.bare_locked && !look.clipped && look.opacity == 1.0;
}

void check_look(const LayerLook& look) {
    check_fields(look);
}

void check_group_look(const LayerLook& look) {
    check_look(look);
    if (look.clipped) throw core::InputError("a group of layers cannot be clipped; its layers can.");
}

void check_stack(const LayerStack& stack) {
    if (stack.layers.empty() || stack.layers.size() > kMostLayers)
        throw core::InputError("a painting has 1 to %1 layers, not %2.", kMostLayers,
                               stack.layers.size());
    if (stack.active >= stack.layers.size()) throw core::InputError("the active layer is none.");
    std::set<LayerId> layers;
    std::set<GroupId> groups;
    for (const LayerGroup& group : stack.groups) {
        check_group_look(group.look);
        if (group.id == 0 || group.id >= stack.next_group || !groups.insert(group.id).second)
            throw core::InputError("there cannot be a group %1.", group.id);
    }
    for (const Layer& layer : stack.layers) {
        check_look(layer.look);
        if (layer.id == 0 || layer.id >= stack.next_layer || !layers.insert(layer.id).second)
            throw core::InputError("there cannot be a layer %1.", layer.id);
        if (layer.group != 0 && !groups.contains(layer.group))
            throw core::InputError("there is no group %1.", layer.group);
    }
    if (!groups_hang_together(stack.layers))
        throw core::InputError("the layers of a group do not lie next to each other.");
}

void check_unlocked(const LayerStack& stack, std::size_t place) {
    if (effective_look(stack, place).locked)
        throw core::InputError("the layer \"%1\" is locked.", stack.layers[place].look.name);
}

void check_paintable(const LayerStack& stack, std::size_t place) {
    check_unlocked(stack, place);
    const auto base = clipped_to(stack, place);
    if (base && stack.layers[place].look.visible && !stack.layers[*base].look.visible)
        throw core::InputError("the layer \"%1\" is clipped to \"%2\", which is hidden.",
                               stack.layers[place].look.name, stack.layers[*base].look.name);
    if (!effective_look(stack, place).visible)
        throw core::InputError("the layer \"%1\" is hidden.", stack.layers[place].look.name);
}

void move_layer(LayerStack& stack, const MoveLayer& move) {
    if (move.group != 0) group_of(stack, move.group);
    check_place(move.place, stack.layers.size() - 1);
    std::vector<Layer> layers = stack.layers;
    const auto from = layers.begin() + static_cast<std::ptrdiff_t>(place_of(stack, move.layer));
    Layer moved = *from;
    moved.group = move.group;
    layers.erase(from);
    layers.insert(layers.begin() + move.place, std::move(moved));
    reorder(stack, std::move(layers),
            core::message("moving the layer there would tear a group of layers apart."));
}

void group_layers(LayerStack& stack, const GroupLayers& group) {
    if (group.layers.empty()) throw core::InputError("a group needs a layer.");
    std::vector<Layer> layers = stack.layers;
    for (const LayerId id : group.layers) {
        Layer& layer = layers[place_of(stack, id)];
        if (layer.group != 0)
            throw core::InputError("the layer \"%1\" is in a group already.", layer.look.name);
        layer.group = stack.next_group;
    }
    reorder(stack, std::move(layers),
            core::message("grouping layers that do not lie next to each other would tear a group of "
                          "layers apart."));
    stack.groups.push_back({stack.next_group++, {.name = group.name}});
}

void move_group(LayerStack& stack, const MoveGroup& move) {
    group_of(stack, move.group);
    std::vector<Layer> others, moved;
    for (const Layer& layer : stack.layers)
        (layer.group == move.group ? moved : others).push_back(layer);
    check_place(move.place, others.size());
    others.insert(others.begin() + move.place, moved.begin(), moved.end());
    reorder(stack, std::move(others),
            core::message("moving the group there would tear a group of layers apart."));
}

void ungroup_layers(LayerStack& stack, GroupId group) {
    group_of(stack, group);
    for (Layer& layer : stack.layers)
        if (layer.group == group) layer.group = 0;
    drop_empty_groups(stack);
}

void drop_empty_groups(LayerStack& stack) {
    std::erase_if(stack.groups, [&](const LayerGroup& group) {
        return std::none_of(stack.layers.begin(), stack.layers.end(),
                            [&](const Layer& layer) { return layer.group == group.id; });
    });
}

}  // namespace pastoso::document
