#include "recordings/selection_json.hpp"

#include <array>
#include <string>
#include <utility>

namespace pastoso::recordings {
namespace {

using document::Combination;

constexpr std::array<std::pair<Combination, const char*>, 4> kCombinations = {
    {{Combination::Replace, "replace"},
     {Combination::Add, "add"},
     {Combination::Subtract, "subtract"},
     {Combination::Intersect, "intersect"}}};

void put_how(Combination how, files::Json& json) {
    for (const auto& [combination, name] : kCombinations)
        if (combination == how && how != Combination::Replace) json["how"] = name;
}

Combination read_how(const files::JsonPlace& select) {
    const auto place = select.optional_entry("how");
    if (!place) return Combination::Replace;
    const std::string wanted = place->text();
    for (const auto& [combination, name] : kCombinations)
        if (wanted == name) return combination;
    place->fail("there is no way \"" + wanted +
                "\" to select; they are replace, add, subtract and intersect.");
}

template <class Range>
files::Json range_json(const Range& select) {
    files::Json json{{"least_mm", select.least_mm}, {"most_mm", select.most_mm}};
    put_how(select.how, json);
    return json;
}

template <class Range>
Range read_range(const files::JsonPlace& place) {
    place.allow_only({"least_mm", "most_mm", "how"});
    return {place.entry("least_mm").number(), place.entry("most_mm").number(), read_how(place)};
}

document::CanvasPoint read_point(const files::JsonPlace& place) {
    if (place.size() != 2) place.fail("a point of an outline has two numbers, x and y.");
    return {place.element(0).number(), place.element(1).number()};
}

}  // namespace

files::Json select_area_json(const document::SelectArea& select) {
    files::Json outline = files::Json::array();
    for (const document::CanvasPoint& point : select.outline)
        outline.push_back({point.x_mm, point.y_mm});
    files::Json json{{"outline_mm", std::move(outline)}};
    put_how(select.how, json);
    return json;
}

files::Json select_by_height_json(const document::SelectByHeight& select) {
    return range_json(select);
}

files::Json select_by_wetness_json(const document::SelectByWetness& select) {
    return range_json(select);
}

document::Action read_select_area(const files::JsonPlace& place) {
    place.allow_only({"outline_mm", "how"});
    document::SelectArea select;
    const files::JsonPlace outline = place.entry("outline_mm");
    for (std::size_t i = 0; i < outline.size(); ++i)
        select.outline.push_back(read_point(outline.element(i)));
    select.how = read_how(place);
    return select;
}

document::Action read_select_by_height(const files::JsonPlace& place) {
    return read_range<document::SelectByHeight>(place);
}

document::Action read_select_by_wetness(const files::JsonPlace& place) {
    return read_range<document::SelectByWetness>(place);
}

}  // namespace pastoso::recordings
