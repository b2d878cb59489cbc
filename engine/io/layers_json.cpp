#include "io/layers_json.hpp"

#include "document/layers.hpp"

#include <limits>

namespace pastoso::io {
namespace {

constexpr std::int64_t kMostId = std::numeric_limits<document::LayerId>::max();

document::GroupId read_group_id(const JsonPlace& place, std::int64_t least) {
    return static_cast<document::GroupId>(place.integer(least, kMostId));
}

int read_place_in_stack(const JsonPlace& place) {
    return static_cast<int>(place.integer(0, document::kMostLayers));
}

}  // namespace

Json look_json(const document::LayerLook& look) {
    Json json{{"name", look.name}};
    if (!look.visible) json["visible"] = false;
    if (look.locked) json["locked"] = true;
    if (look.opacity != 1.0) json["opacity"] = look.opacity;
    return json;
}

document::LayerLook read_look(const JsonPlace& place) {
    document::LayerLook look;
    look.name = place.entry("name").text();
    look.visible = place.boolean_or("visible", true);
    look.locked = place.boolean_or("locked", false);
    look.opacity = place.number_or("opacity", 1.0);
    return look;
}

Json set_layer_json(const document::SetLayer& set) {
    Json json = look_json(set.look);
    json["layer"] = set.layer;
    return json;
}

Json set_group_json(const document::SetGroup& set) {
    Json json = look_json(set.look);
    json["group"] = set.group;
    return json;
}

Json move_layer_json(const document::MoveLayer& move) {
    Json json{{"layer", move.layer}, {"place", move.place}};
    if (move.group != 0) json["group"] = move.group;
    return json;
}

Json move_group_json(const document::MoveGroup& move) {
    return {{"group", move.group}, {"place", move.place}};
}

Json group_layers_json(const document::GroupLayers& group) {
    return {{"name", group.name}, {"layers", group.layers}};
}

document::LayerId read_layer_id(const JsonPlace& place) {
    return static_cast<document::LayerId>(place.integer(1, kMostId));
}

document::Action read_add_layer(const JsonPlace& place) {
    place.allow_only({"name"});
    return document::AddLayer{place.entry("name").text()};
}

document::Action read_set_layer(const JsonPlace& place) {
    place.allow_only({"layer", "name", "visible", "locked", "opacity"});
    return document::SetLayer{read_layer_id(place.entry("layer")), read_look(place)};
}

document::Action read_set_group(const JsonPlace& place) {
    place.allow_only({"group", "name", "visible", "locked", "opacity"});
    return document::SetGroup{read_group_id(place.entry("group"), 1), read_look(place)};
}

document::Action read_move_layer(const JsonPlace& place) {
    place.allow_only({"layer", "place", "group"});
    document::MoveLayer move{read_layer_id(place.entry("layer")),
                             read_place_in_stack(place.entry("place")), 0};
    if (const auto group = place.optional_entry("group")) move.group = read_group_id(*group, 0);
    return move;
}

document::Action read_move_group(const JsonPlace& place) {
    place.allow_only({"group", "place"});
    return document::MoveGroup{read_group_id(place.entry("group"), 1),
                               read_place_in_stack(place.entry("place"))};
}

document::Action read_group_layers(const JsonPlace& place) {
    place.allow_only({"name", "layers"});
    document::GroupLayers group{place.entry("name").text(), {}};
    const JsonPlace layers = place.entry("layers");
    for (std::size_t i = 0; i < layers.size(); ++i)
        group.layers.push_back(read_layer_id(layers.element(i)));
    return group;
}

document::Action read_ungroup_layers(const JsonPlace& place) {
    place.allow_only({"group"});
    return document::UngroupLayers{read_group_id(place.entry("group"), 1)};
}

}  // namespace pastoso::io
