#include "brush/preset_fields.hpp"
#include "brush/preset_names.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace pastoso::brush {
namespace {

using Json = nlohmann::ordered_json;

Json number_json(const PresetField& field, double value) {
    if (field.whole) return static_cast<std::int64_t>(std::llround(value));
    return value;
}

Json curve_json(const DynamicsCurve& curve) {
    Json points = Json::array();
    for (const CurvePoint& point : curve.points)
        points.push_back({point.input, point.output});
    return {{"input", word_for(curve.input, kInputNames)},
            {"target", word_for(curve.target, kTargetNames)},
            {"curve", std::move(points)}};
}

}  // namespace

std::string preset_to_json(const Preset& preset) {
    Json json{{"version", kPresetVersion},
              {"kind", word_for(preset.kind, kKindNames)},
              {"name", preset.name},
              {"dips", preset.dips},
              {"units", {{"length", "mm"}, {"angle", "deg"}, {"volume", "mm3"}}}};
    if (preset.kind == ToolKind::Contact) json["tip"]["shape"] = word_for(preset.tip.shape, kShapeNames);
    for (const PresetField& field : preset_fields()) {
        if (applies_to(field, preset.kind))
            json[std::string(field.section)][std::string(field.key)] =
                number_json(field, field.get(preset));
    }
    if (preset.kind == ToolKind::Contact) json["exchange"]["absorbs"] = preset.exchange.absorbs;
    json["stroke"]["jitter_seed"] = word_for(preset.stroke.jitter_seed, kJitterSeedNames);
    json["dynamics"] = Json::array();
    for (const DynamicsCurve& curve : preset.dynamics)
        json["dynamics"].push_back(curve_json(curve));
    return json.dump(2) + "\n";
}

}  // namespace pastoso::brush
