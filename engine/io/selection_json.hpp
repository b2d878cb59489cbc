// Selections in recordings.
#pragma once

#include "document/events.hpp"
#include "io/json_place.hpp"

namespace pastoso::io {

Json select_area_json(const document::SelectArea& select);
Json select_by_height_json(const document::SelectByHeight& select);
Json select_by_wetness_json(const document::SelectByWetness& select);

document::Action read_select_area(const JsonPlace& place);
document::Action read_select_by_height(const JsonPlace& place);
document::Action read_select_by_wetness(const JsonPlace& place);

}  // namespace pastoso::io
