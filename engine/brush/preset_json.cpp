#include "brush/preset.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <nlohmann/json.hpp>

namespace pastoso::brush {
namespace {

using Json = nlohmann::json;

template <class T>
struct Named {
    const char* name;
    T value;
};

constexpr Named<TipShape> kShapes[] = {{"round", TipShape::Round},
                                       {"flat", TipShape::Flat},
                                       {"filbert", TipShape::Filbert},
                                       {"fan", TipShape::Fan},
                                       {"knife", TipShape::Knife}};
constexpr Named<JitterSeed> kJitterSeeds[] = {{"stroke", JitterSeed::Stroke},
                                              {"brush", JitterSeed::Brush}};
constexpr Named<DynamicsInput> kInputs[] = {{"pressure", DynamicsInput::Pressure},
                                            {"tilt", DynamicsInput::Tilt},
                                            {"barrel_rotation", DynamicsInput::BarrelRotation},
                                            {"speed_mm_s", DynamicsInput::Speed}};
constexpr Named<DynamicsTarget> kTargets[] = {
    {"press", DynamicsTarget::Press},       {"lean", DynamicsTarget::Lean},
    {"rotation", DynamicsTarget::Rotation}, {"reach", DynamicsTarget::Reach},
    {"film", DynamicsTarget::Film},         {"pickup", DynamicsTarget::Pickup}};
constexpr std::size_t kMostCurvePoints = 64;

struct Range {
    double low, high;
};

std::string text_of(double number) {
    return Json(number).dump();
}

/// One object of the file, with its path for messages.
class Section {
  public:
    Section(const Json& json, std::string file, std::string path)
        : json_(json), file_(std::move(file)), path_(std::move(path)) {
        if (!json_.is_object()) fail(path_, "must be an object, not " + json_.dump());
    }

    Section section(const char* key) const { return {field(key), file_, path_of(key)}; }

    double number(const char* key, Range range) const {
        const Json& value = field(key);
        if (!value.is_number()) fail(path_of(key), "must be a number, not " + value.dump());
        const auto number = value.get<double>();
        if (!(number >= range.low && number <= range.high)) {
            fail(path_of(key), "is " + value.dump() + ", outside " + text_of(range.low) + " to " +
                                   text_of(range.high));
        }
        return number;
    }

    int whole_number(const char* key, Range range) const {
        const double value = number(key, range);
        if (value != std::floor(value))
            fail(path_of(key), "must be a whole number, not " + text_of(value));
        return static_cast<int>(value);
    }

    std::string text(const char* key) const {
        const Json& value = field(key);
        if (!value.is_string()) fail(path_of(key), "must be a text, not " + value.dump());
        return value.get<std::string>();
    }

    template <class T, std::size_t N>
    T choice(const char* key, const Named<T> (&choices)[N]) const {
        const std::string value = text(key);
        std::string names;
        for (const Named<T>& candidate : choices) {
            if (value == candidate.name) return candidate.value;
            names += (names.empty() ? "" : ", ") + std::string(candidate.name);
        }
        fail(path_of(key), "is \"" + value + "\", which is none of: " + names);
    }

    const Json& list(const char* key) const {
        const Json& value = field(key);
        if (!value.is_array()) fail(path_of(key), "must be a list, not " + value.dump());
        return value;
    }

    /// Fails on fields that are none of `known`.
    void check_fields(std::initializer_list<const char*> known) const {
        for (const auto& item : json_.items()) {
            const bool is_known = std::any_of(known.begin(), known.end(),
                                              [&](const char* name) { return item.key() == name; });
            if (!is_known) {
                fail(path_of(item.key()),
                     "is not a field of a brush preset (value " + item.value().dump() + ")");
            }
        }
    }

    [[noreturn]] void fail(const std::string& path, const std::string& problem) const {
        throw core::InputError(file_ + ": " + (path.empty() ? "the preset" : path) + " " + problem +
                               ".");
    }

    std::string path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

  private:
    const Json& field(const char* key) const {
        const auto found = json_.find(key);
        if (found == json_.end()) fail(path_of(key), "is missing");
        return *found;
    }

    const Json& json_;
    std::string file_;
    std::string path_;
};

void check_units(const Section& units) {
    constexpr Named<int> kLength[] = {{"mm", 0}};
    constexpr Named<int> kAngle[] = {{"deg", 0}};
    constexpr Named<int> kVolume[] = {{"mm3", 0}};
    units.check_fields({"length", "angle", "volume"});
    units.choice("length", kLength);
    units.choice("angle", kAngle);
    units.choice("volume", kVolume);
}

TipPreset read_tip(const Section& tip) {
    tip.check_fields(
        {"shape", "width", "thickness", "length", "point", "bristles", "hairs_per_bristle", "seed"});
    TipPreset result;
    result.shape = tip.choice("shape", kShapes);
    result.width_mm = tip.number("width", {0.5, 200.0});
    result.thickness_mm = tip.number("thickness", {0.1, 200.0});
    result.length_mm = tip.number("length", {1.0, 400.0});
    result.point_mm = tip.number("point", {0.0, result.length_mm});
    result.bristles = tip.whole_number("bristles", {4, 2000});
    result.hairs_per_bristle = tip.whole_number("hairs_per_bristle", {1, 64});
    result.seed = static_cast<std::uint32_t>(tip.whole_number("seed", {0, 1e9}));
    return result;
}

FlexPreset read_flex(const Section& flex) {
    flex.check_fields({"bend", "splay", "lag", "press_depth", "tilt_gain", "descend", "rigidity"});
    FlexPreset result;
    result.bend = flex.number("bend", {0.0, 1.0});
    result.splay = flex.number("splay", {0.0, 3.0});
    result.lag = flex.number("lag", {0.05, 20.0});
    result.press_depth = flex.number("press_depth", {0.01, 0.9});
    result.tilt_gain = flex.number("tilt_gain", {0.0, 3.0});
    result.descend = flex.number("descend", {0.0, 10.0});
    result.rigidity = flex.number("rigidity", {0.0, 1.0});
    return result;
}

PaintPreset read_paint(const Section& paint) {
    paint.check_fields({"film", "run", "groove", "hair", "streak", "edge", "start", "leave", "reach"});
    PaintPreset result;
    result.film_mm = paint.number("film", {0.005, 3.0});
    result.run_mm = paint.number("run", {1.0, 10000.0});
    result.groove = paint.number("groove", {0.0, 3.0});
    result.hair = paint.number("hair", {0.0, 5.0});
    result.streak = paint.number("streak", {0.0, 1.0});
    result.edge = paint.number("edge", {0.0, 3.0});
    result.start = paint.number("start", {0.0, 5.0});
    result.leave = paint.number("leave", {0.0, 1.0});
    result.reach = paint.number("reach", {0.1, 50.0});
    return result;
}

ExchangePreset read_exchange(const Section& exchange) {
    exchange.check_fields({"pickup", "mix", "wick", "momentum", "overflow"});
    ExchangePreset result;
    result.pickup = exchange.number("pickup", {0.0, 1.0});
    result.mix = exchange.number("mix", {0.0, 1.0});
    result.wick = exchange.number("wick", {0.0, 1.0});
    result.momentum = exchange.number("momentum", {0.0, 1.0});
    result.overflow = exchange.number("overflow", {1.0, 3.0});
    return result;
}

StrokePreset read_stroke(const Section& stroke) {
    stroke.check_fields({"spacing", "min_spacing", "smoothing_ms", "string_mm", "jitter_seed"});
    StrokePreset result;
    result.spacing = stroke.number("spacing", {0.1, 1.0});
    result.min_spacing_mm = stroke.number("min_spacing", {0.02, 2.0});
    result.smoothing_ms = stroke.number("smoothing_ms", {0.0, 200.0});
    result.string_mm = stroke.number("string_mm", {0.0, 50.0});
    result.jitter_seed = stroke.choice("jitter_seed", kJitterSeeds);
    return result;
}

std::vector<CurvePoint> read_points(const Section& curve) {
    const Json& list = curve.list("curve");
    const std::string path = curve.path_of("curve");
    if (list.empty() || list.size() > kMostCurvePoints) {
        curve.fail(path, "must have 1 to " + std::to_string(kMostCurvePoints) + " points, not " +
                             std::to_string(list.size()));
    }
    std::vector<CurvePoint> points;
    for (const Json& point : list) {
        const std::string where = path + "[" + std::to_string(points.size()) + "]";
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number()) {
            curve.fail(where, "must be two numbers, not " + point.dump());
        }
        points.push_back({point[0].get<double>(), point[1].get<double>()});
        if (points.size() > 1 && points.back().input <= points[points.size() - 2].input) {
            curve.fail(where,
                       "is " + point.dump() + ", whose input is not above that of the point before it");
        }
    }
    return points;
}

/// A lean is a length along the tilt, a rotation an angle: only their own inputs can give them.
void check_pair(const Section& section, const DynamicsCurve& curve) {
    const bool lean_fits = (curve.target != DynamicsTarget::Lean) || curve.input == DynamicsInput::Tilt;
    const bool rotation_fits =
        (curve.target != DynamicsTarget::Rotation) || curve.input == DynamicsInput::BarrelRotation;
    if (!lean_fits || !rotation_fits) {
        section.fail(
            section.path_of("input"),
            "is \"" + section.text("input") + "\", which cannot set \"" + section.text("target") + "\"");
    }
}

std::vector<DynamicsCurve> read_dynamics(const Json& list, const std::string& file_name) {
    std::vector<DynamicsCurve> curves;
    for (const Json& entry : list) {
        const Section section(entry, file_name, "dynamics[" + std::to_string(curves.size()) + "]");
        section.check_fields({"input", "target", "curve"});
        curves.push_back({section.choice("input", kInputs), section.choice("target", kTargets),
                          read_points(section)});
        check_pair(section, curves.back());
    }
    return curves;
}

Json parse_json(std::string_view text, const std::string& file_name) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw core::located_error(file_name, 1 + std::count(text.begin(), end, '\n'),
                                  "this is not valid JSON.");
    } catch (const Json::exception& error) {
        throw core::InputError(file_name + ": holds a number that is too large (" + error.what() + ").");
    }
}

}  // namespace

Preset parse_preset(std::string_view json_text, const std::string& file_name) {
    const Json json = parse_json(json_text, file_name);
    const Section root(json, file_name, "");
    root.check_fields(
        {"version", "units", "name", "tip", "flex", "paint", "exchange", "stroke", "dynamics"});
    root.whole_number("version", {1, 1});
    check_units(root.section("units"));
    Preset preset;
    preset.name = root.text("name");
    if (preset.name.empty()) root.fail("name", "is empty");
    preset.tip = read_tip(root.section("tip"));
    preset.flex = read_flex(root.section("flex"));
    preset.paint = read_paint(root.section("paint"));
    preset.exchange = read_exchange(root.section("exchange"));
    preset.stroke = read_stroke(root.section("stroke"));
    preset.dynamics = read_dynamics(root.list("dynamics"), file_name);
    return preset;
}

}  // namespace pastoso::brush
