// Selections in recordings.
#pragma once

#include "document/events.hpp"
#include "files/json_place.hpp"

namespace pastoso::recordings {

files::Json select_area_json(const document::SelectArea& select);
files::Json select_by_height_json(const document::SelectByHeight& select);
files::Json select_by_wetness_json(const document::SelectByWetness& select);

document::Action read_select_area(const files::JsonPlace& place);
document::Action read_select_by_height(const files::JsonPlace& place);
document::Action read_select_by_wetness(const files::JsonPlace& place);

}  // namespace pastoso::recordings
