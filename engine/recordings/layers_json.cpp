#include "recordings/layers_json.hpp"

#include "document/layers.hpp"

#include <limits>

namespace pastoso::recordings {
namespace {

constexpr std::int64_t kMostId = std::numeric_limits<document::LayerId>::max();

document::GroupId read_group_id(const files::JsonPlace& place, std::int64_t least) {
    return static_cast<document::GroupId>(place.integer(least, kMostId));
}

int read_place_in_stack(const files::JsonPlace& place) {
    return static_cast<int>(place.integer(0, document::kMostLayers));
}

/// Two numbers, where they are given.
void read_pair(const files::JsonPlace& object, const char* key, double& x, double& y) {
    const auto pair = object.optional_entry(key);
    if (!pair) return;
    if (pair->size() != 2) pair->fail("expected two numbers, x and y.");
    x = pair->element(0).number();
    y = pair->element(1).number();
}

}  // namespace

files::Json look_json(const document::LayerLook& look) {
    files::Json json{{"name", look.name}};
    if (!look.visible) json["visible"] = false;
    if (look.locked) json["locked"] = true;
    if (look.opacity != 1.0) json["opacity"] = look.opacity;
    return json;
}

document::LayerLook read_look(const files::JsonPlace& place) {
    document::LayerLook look;
    look.name = place.entry("name").text();
    look.visible = place.boolean_or("visible", true);
    look.locked = place.boolean_or("locked", false);
    look.opacity = place.number_or("opacity", 1.0);
    return look;
}

files::Json set_layer_json(const document::SetLayer& set) {
    files::Json json = look_json(set.look);
    json["layer"] = set.layer;
    return json;
}

files::Json set_group_json(const document::SetGroup& set) {
    files::Json json = look_json(set.look);
    json["group"] = set.group;
    return json;
}

files::Json transform_layer_json(const document::TransformLayer& move) {
    const layers::Transform& transform = move.transform;
    return {{"layer", move.layer},
            {"centre_mm", {transform.centre_x_mm, transform.centre_y_mm}},
            {"move_mm", {transform.move_x_mm, transform.move_y_mm}},
            {"turn_deg", transform.turn_deg},
            {"scale", {transform.scale_x, transform.scale_y}}};
}

files::Json move_layer_json(const document::MoveLayer& move) {
    files::Json json{{"layer", move.layer}, {"place", move.place}};
    if (move.group != 0) json["group"] = move.group;
    return json;
}

files::Json move_group_json(const document::MoveGroup& move) {
    return {{"group", move.group}, {"place", move.place}};
}

files::Json group_layers_json(const document::GroupLayers& group) {
    return {{"name", group.name}, {"layers", group.layers}};
}

document::LayerId read_layer_id(const files::JsonPlace& place) {
    return static_cast<document::LayerId>(place.integer(1, kMostId));
}

document::Action read_add_layer(const files::JsonPlace& place) {
    place.allow_only({"name"});
    return document::AddLayer{place.entry("name").text()};
}

document::Action read_set_layer(const files::JsonPlace& place) {
    place.allow_only({"layer", "name", "visible", "locked", "opacity"});
    return document::SetLayer{read_layer_id(place.entry("layer")), read_look(place)};
}

document::Action read_set_group(const files::JsonPlace& place) {
    place.allow_only({"group", "name", "visible", "locked", "opacity"});
    return document::SetGroup{read_group_id(place.entry("group"), 1), read_look(place)};
}

document::Action read_transform_layer(const files::JsonPlace& place) {
    place.allow_only({"layer", "centre_mm", "move_mm", "turn_deg", "scale"});
    document::TransformLayer move{read_layer_id(place.entry("layer")), {}};
    layers::Transform& transform = move.transform;
    read_pair(place, "centre_mm", transform.centre_x_mm, transform.centre_y_mm);
    read_pair(place, "move_mm", transform.move_x_mm, transform.move_y_mm);
    transform.turn_deg = place.number_or("turn_deg", 0.0);
    read_pair(place, "scale", transform.scale_x, transform.scale_y);
    return move;
}

document::Action read_move_layer(const files::JsonPlace& place) {
    place.allow_only({"layer", "place", "group"});
    document::MoveLayer move{read_layer_id(place.entry("layer")),
                             read_place_in_stack(place.entry("place")), 0};
    if (const auto group = place.optional_entry("group")) move.group = read_group_id(*group, 0);
    return move;
}

document::Action read_move_group(const files::JsonPlace& place) {
    place.allow_only({"group", "place"});
    return document::MoveGroup{read_group_id(place.entry("group"), 1),
                               read_place_in_stack(place.entry("place"))};
}

document::Action read_group_layers(const files::JsonPlace& place) {
    place.allow_only({"name", "layers"});
    document::GroupLayers group{place.entry("name").text(), {}};
    const files::JsonPlace layers = place.entry("layers");
    for (std::size_t i = 0; i < layers.size(); ++i)
        group.layers.push_back(read_layer_id(layers.element(i)));
    return group;
}

document::Action read_ungroup_layers(const files::JsonPlace& place) {
    place.allow_only({"group"});
    return document::UngroupLayers{read_group_id(place.entry("group"), 1)};
}

}  // namespace pastoso::recordings
