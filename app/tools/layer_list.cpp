#include "tools/layer_list.hpp"

#include <algorithm>
#include <cstddef>

namespace pastoso::tools {
namespace {

using document::LayerId;
using document::LayerStack;

bool contains(const std::vector<LayerRow>& rows, const LayerRow& row) {
    return std::find(rows.begin(), rows.end(), row) != rows.end();
}

bool is_one_of(const std::vector<LayerRow>& rows, const document::Layer& layer) {
    return contains(rows, {.layer = layer.id}) ||
           (layer.group != 0 && contains(rows, {.group = layer.group}));
}

struct ListPlace {
    std::size_t entry = 0;
    std::optional<std::size_t> child{};  ///< of a group
};

ListPlace find_row(const std::vector<LayerEntry>& entries, const LayerRow& row) {
    ListPlace place;
    for (; place.entry < entries.size(); ++place.entry) {
        const LayerEntry& entry = entries[place.entry];
        if (entry.row == row) break;
        const auto child = std::find(entry.children.begin(), entry.children.end(), row.layer);
        if (row.layer == 0 || child == entry.children.end()) continue;
        place.child = static_cast<std::size_t>(child - entry.children.begin());
        break;
    }
    return place;
}

/// The layers that stand below a gap.
std::vector<LayerId> layers_below(const std::vector<LayerEntry>& entries, const LayerGap& gap) {
    std::vector<LayerId> below;
    bool passed = false;
    for (std::size_t number = 0; number < entries.size(); ++number) {
        const LayerEntry& entry = entries[number];
        std::size_t first = entry.children.size();
        if (gap.group == 0) passed = passed || static_cast<int>(number) >= gap.row;
        if (passed) first = 0;
        if (gap.group != 0 && entry.row.group == gap.group) {
            first = std::min(static_cast<std::size_t>(gap.row), first);
            passed = true;
        } else if (passed && entry.row.layer != 0) {
            below.push_back(entry.row.layer);
        }
        below.insert(below.end(), entry.children.begin() + static_cast<std::ptrdiff_t>(first),
                     entry.children.end());
    }
    return below;
}

std::vector<LayerEntry> after(const LayerStack& stack, const document::Action& move) {
    LayerStack moved = stack;
    if (const auto* layer = std::get_if<document::MoveLayer>(&move)) document::move_layer(moved, *layer);
    if (const auto* group = std::get_if<document::MoveGroup>(&move)) document::move_group(moved, *group);
    return layer_entries(moved);
}

}  // namespace

std::vector<LayerEntry> layer_entries(const LayerStack& stack) {
    std::vector<LayerEntry> entries;
    for (auto layer = stack.layers.rbegin(); layer != stack.layers.rend(); ++layer) {
        if (layer->group == 0) {
            entries.push_back({.row = {.layer = layer->id}});
            continue;
        }
        if (entries.empty() || entries.back().row.group != layer->group)
            entries.push_back({.row = {.group = layer->group}});
        entries.back().children.push_back(layer->id);
    }
    return entries;
}

std::optional<document::Action> move_to(const LayerStack& stack, const LayerRow& row,
                                        const LayerGap& gap) {
    if (row.group != 0 && gap.group != 0) return std::nullopt;
    const std::vector<LayerEntry> entries = layer_entries(stack);
    const std::vector<LayerId> below = layers_below(entries, gap);
    const auto place = static_cast<int>(
        std::count_if(stack.layers.begin(), stack.layers.end(), [&](const document::Layer& layer) {
            return !is_one_of({row}, layer) &&
                   std::find(below.begin(), below.end(), layer.id) != below.end();
        }));
    const document::Action move = row.group != 0
                                      ? document::Action(document::MoveGroup{row.group, place})
                                      : document::MoveLayer{row.layer, place, gap.group};
    return after(stack, move) == entries ? std::nullopt : std::optional(move);
}

std::optional<LayerGap> step_from(const LayerStack& stack, const LayerRow& row, bool up) {
    const std::vector<LayerEntry> entries = layer_entries(stack);
    const ListPlace place = find_row(entries, row);
    const auto number = static_cast<int>(place.entry);
    if (place.child) {
        const LayerEntry& group = entries[place.entry];
        const bool at_end = up ? *place.child == 0 : *place.child + 1 == group.children.size();
        if (at_end) return LayerGap{0, up ? number : number + 1};
        const auto child = static_cast<int>(*place.child);
        return LayerGap{group.row.group, up ? child - 1 : child + 2};
    }
    if (up ? number == 0 : place.entry + 1 >= entries.size()) return std::nullopt;
    const LayerEntry& next = entries[up ? place.entry - 1 : place.entry + 1];
    if (next.row.group == 0 || row.group != 0) return LayerGap{0, up ? number - 1 : number + 2};
    return LayerGap{next.row.group, up ? static_cast<int>(next.children.size()) : 0};
}

std::vector<LayerId> layers_in(const LayerStack& stack, const std::vector<LayerRow>& rows) {
    std::vector<LayerId> layers;
    for (const document::Layer& layer : stack.layers)
        if (is_one_of(rows, layer)) layers.push_back(layer.id);
    return layers;
}

document::LayerLook look_of(const LayerStack& stack, const LayerRow& row) {
    for (const document::LayerGroup& group : stack.groups)
        if (row.group == group.id) return group.look;
    return stack.layers[document::place_of(stack, row.layer)].look;
}

document::Action set_look(const LayerRow& row, const document::LayerLook& look) {
    if (row.group != 0) return document::SetGroup{row.group, look};
    return document::SetLayer{row.layer, look};
}

}  // namespace pastoso::tools
