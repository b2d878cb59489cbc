// Changes of layers in recordings.
#pragma once

#include "document/events.hpp"
#include "io/json_place.hpp"

namespace pastoso::io {

/// {"name": ..., "visible": ..., "locked": ..., "opacity": ...}; what is as in a new layer is left out,
/// but for the name.
Json look_json(const document::LayerLook& look);

/// Of an object that has other entries besides.
document::LayerLook read_look(const JsonPlace& place);

Json set_layer_json(const document::SetLayer& set);
Json set_group_json(const document::SetGroup& set);
Json move_layer_json(const document::MoveLayer& move);
Json move_group_json(const document::MoveGroup& move);
Json group_layers_json(const document::GroupLayers& group);

document::Action read_add_layer(const JsonPlace& place);
document::Action read_set_layer(const JsonPlace& place);
document::Action read_set_group(const JsonPlace& place);
document::Action read_move_layer(const JsonPlace& place);
document::Action read_move_group(const JsonPlace& place);
document::Action read_group_layers(const JsonPlace& place);
document::Action read_ungroup_layers(const JsonPlace& place);

document::LayerId read_layer_id(const JsonPlace& place);

/// Of the actions that say nothing but which layer.
template <class OfLayer>
document::Action read_of_layer(const JsonPlace& place) {
    place.allow_only({"layer"});
    return OfLayer{read_layer_id(place.entry("layer"))};
}

}  // namespace pastoso::io
