// Changes of layers in recordings.
#pragma once

#include "document/events.hpp"
#include "files/json_place.hpp"

namespace pastoso::recordings {

/// {"name": ..., "visible": ..., "locked": ..., "opacity": ...}; what is as in a new layer is left out,
/// but for the name.
files::Json look_json(const document::LayerLook& look);

/// Of an object that has other entries besides.
document::LayerLook read_look(const files::JsonPlace& place);

files::Json set_layer_json(const document::SetLayer& set);
files::Json set_group_json(const document::SetGroup& set);
files::Json transform_layer_json(const document::TransformLayer& move);
files::Json move_layer_json(const document::MoveLayer& move);
files::Json move_group_json(const document::MoveGroup& move);
files::Json group_layers_json(const document::GroupLayers& group);

document::Action read_add_layer(const files::JsonPlace& place);
document::Action read_set_layer(const files::JsonPlace& place);
document::Action read_set_group(const files::JsonPlace& place);
document::Action read_transform_layer(const files::JsonPlace& place);
document::Action read_move_layer(const files::JsonPlace& place);
document::Action read_move_group(const files::JsonPlace& place);
document::Action read_group_layers(const files::JsonPlace& place);
document::Action read_ungroup_layers(const files::JsonPlace& place);

document::LayerId read_layer_id(const files::JsonPlace& place);

/// Of the actions that say nothing but which layer.
template <class OfLayer>
document::Action read_of_layer(const files::JsonPlace& place) {
    place.allow_only({"layer"});
    return OfLayer{read_layer_id(place.entry("layer"))};
}

}  // namespace pastoso::recordings
