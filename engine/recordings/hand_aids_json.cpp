#include "recordings/hand_aids_json.hpp"

#include "document/action_checks.hpp"

namespace pastoso::recordings {
namespace {

struct GuideForm {
    files::Json operator()(std::monostate) const { return {{"form", "none"}}; }
    files::Json operator()(const brush::StraightLine&) const { return {{"form", "line"}}; }
    files::Json operator()(const brush::Ruler& ruler) const {
        return {{"form", "ruler"},
                {"from_mm", files::Json::array({ruler.x1_mm, ruler.y1_mm})},
                {"to_mm", files::Json::array({ruler.x2_mm, ruler.y2_mm})}};
    }
    files::Json operator()(const brush::EllipseCurve& ellipse) const {
        return {{"form", "ellipse"},
                {"centre_mm", files::Json::array({ellipse.centre_x_mm, ellipse.centre_y_mm})},
                {"half_width_mm", ellipse.half_width_mm},
                {"half_height_mm", ellipse.half_height_mm},
                {"turn_deg", ellipse.turn_deg}};
    }
};

struct Point {
    double x_mm, y_mm;
};

Point read_point(const files::JsonPlace& place) {
    if (place.size() != 2) place.fail("expected a point, for example [20, 30].");
    return {place.element(0).number(), place.element(1).number()};
}

brush::Ruler read_ruler(const files::JsonPlace& place) {
    place.allow_only({"form", "from_mm", "to_mm", "reach_mm", "turn_across"});
    const Point from = read_point(place.entry("from_mm")), to = read_point(place.entry("to_mm"));
    return {from.x_mm, from.y_mm, to.x_mm, to.y_mm};
}

brush::EllipseCurve read_ellipse(const files::JsonPlace& place) {
    place.allow_only(
        {"form", "centre_mm", "half_width_mm", "half_height_mm", "turn_deg", "reach_mm", "turn_across"});
    const Point centre = read_point(place.entry("centre_mm"));
    return {centre.x_mm, centre.y_mm, place.entry("half_width_mm").number(),
            place.entry("half_height_mm").number(), place.number_or("turn_deg", 0.0)};
}

}  // namespace

files::Json stabiliser_json(const brush::Stabiliser& stabiliser) {
    return {{"smoothing_ms", stabiliser.smoothing_ms}, {"string_mm", stabiliser.string_mm}};
}

files::Json guide_json(const brush::PenGuide& guide) {
    files::Json json = std::visit(GuideForm{}, guide.form);
    if (guide.reach_mm != brush::PenGuide{}.reach_mm) json["reach_mm"] = guide.reach_mm;
    if (guide.turn_across) json["turn_across"] = true;
    return json;
}

files::Json symmetry_json(const brush::Symmetry& symmetry) {
    files::Json json{{"centre_x_mm", symmetry.centre_x_mm}, {"centre_y_mm", symmetry.centre_y_mm}};
    if (symmetry.axis_deg != brush::Symmetry{}.axis_deg) json["axis_deg"] = symmetry.axis_deg;
    if (symmetry.mirror) json["mirror"] = true;
    if (symmetry.count != 1) json["count"] = symmetry.count;
    return json;
}

document::Action read_stabiliser(const files::JsonPlace& place) {
    place.allow_only({"smoothing_ms", "string_mm"});
    return document::SetStabiliser{
        {place.number_or("smoothing_ms", 0.0), place.number_or("string_mm", 0.0)}};
}

document::Action read_guide(const files::JsonPlace& place) {
    brush::PenGuide guide;
    const files::JsonPlace form = place.entry("form");
    const std::string name = form.text();
    if (name == "ruler") {
        guide.form = read_ruler(place);
    } else if (name == "ellipse") {
        guide.form = read_ellipse(place);
    } else {
        place.allow_only({"form", "reach_mm", "turn_across"});
        if (name == "line") guide.form = brush::StraightLine{};
        if (name != "line" && name != "none")
            form.fail("\"" + name + "\" is not one of none, line, ruler and ellipse.");
    }
    guide.reach_mm = place.number_or("reach_mm", guide.reach_mm);
    guide.turn_across = place.boolean_or("turn_across", false);
    return document::SetGuide{guide};
}

document::Action read_symmetry(const files::JsonPlace& place) {
    place.allow_only({"centre_x_mm", "centre_y_mm", "axis_deg", "mirror", "count"});
    brush::Symmetry symmetry;
    symmetry.centre_x_mm = place.entry("centre_x_mm").number();
    symmetry.centre_y_mm = place.entry("centre_y_mm").number();
    symmetry.axis_deg = place.number_or("axis_deg", symmetry.axis_deg);
    symmetry.mirror = place.boolean_or("mirror", false);
    if (const auto count = place.optional_entry("count"))
        symmetry.count = static_cast<int>(count->integer(1, document::kMostCopies));
    return document::SetSymmetry{symmetry};
}

}  // namespace pastoso::recordings
