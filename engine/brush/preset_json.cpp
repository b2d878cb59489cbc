#include "brush/preset.hpp"
#include "brush/preset_fields.hpp"
#include "brush/preset_names.hpp"
#include "core/error.hpp"
#include "core/json_depth.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

namespace pastoso::brush {
namespace {

using Json = nlohmann::json;

struct Range {
    double low, high;
};

std::string text_of(double number) {
    return Json(number).dump();
}

/// One object of the file, with its path for messages.
class Section {
  public:
    Section(const Json& json, core::Message file, std::string path)
        : json_(json), file_(std::move(file)), path_(std::move(path)) {
        if (!json_.is_object()) fail(path_, "%1 must be an object, not %2.", json_.dump());
    }

    Section section(std::string_view key) const { return {field(key), file_, path_of(key)}; }

    double number(std::string_view key, Range range) const {
        const Json& value = field(key);
        if (!value.is_number()) fail(path_of(key), "%1 must be a number, not %2.", value.dump());
        const auto number = value.get<double>();
        if (!(number >= range.low && number <= range.high)) {
            fail(path_of(key), "%1 is %2, outside %3 to %4.", value.dump(), text_of(range.low),
                 text_of(range.high));
        }
        return number;
    }

    int whole_number(std::string_view key, Range range) const {
        const double value = number(key, range);
        if (value != std::floor(value))
            fail(path_of(key), "%1 must be a whole number, not %2.", text_of(value));
        return static_cast<int>(value);
    }

    std::string text(std::string_view key) const {
        const Json& value = field(key);
        if (!value.is_string()) fail(path_of(key), "%1 must be a text, not %2.", value.dump());
        return value.get<std::string>();
    }

    template <class T, std::size_t N>
    T choice(std::string_view key, const Named<T> (&choices)[N]) const {
        const std::string value = text(key);
        std::string names;
        for (const Named<T>& candidate : choices) {
            if (value == candidate.name) return candidate.value;
            names += (names.empty() ? "" : ", ") + std::string(candidate.name);
        }
        fail(path_of(key), "%1 is \"%2\", which is none of: %3.", value, names);
    }

    const Json& list(std::string_view key) const {
        const Json& value = field(key);
        if (!value.is_array()) fail(path_of(key), "%1 must be a list, not %2.", value.dump());
        return value;
    }

    bool truth(std::string_view key) const {
        const Json& value = field(key);
        if (!value.is_boolean()) fail(path_of(key), "%1 must be true or false, not %2.", value.dump());
        return value.get<bool>();
    }

    /// Fails on fields that are none of `known`.
    void check_fields(const std::vector<std::string_view>& known) const {
        for (const auto& item : json_.items()) {
            if (std::find(known.begin(), known.end(), item.key()) == known.end()) {
                fail(path_of(item.key()), "%1 is not a field of a brush preset (value %2).",
                     item.value().dump());
            }
        }
    }

    /// The pattern's first place is that of the path.
    template <class... Arguments>
    [[noreturn]] void fail(const std::string& path, core::Pattern<sizeof...(Arguments) + 1> pattern,
                           const Arguments&... arguments) const {
        const auto place = path.empty() ? core::message("the preset") : core::Message::verbatim(path);
        throw core::InputError("%1: %2", file_, core::message(pattern, place, arguments...));
    }

    std::string path_of(std::string_view key) const {
        return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
    }

  private:
    const Json& field(std::string_view key) const {
        const auto found = json_.find(key);
        if (found == json_.end()) fail(path_of(key), "%1 is missing.");
        return *found;
    }

    const Json& json_;
    core::Message file_;
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

/// The keys of a section that are no plain numbers.
std::vector<std::string_view> other_keys(std::string_view section, ToolKind kind) {
    if (section == "stroke") return {"jitter_seed"};
    if (kind != ToolKind::Contact) return {};
    if (section == "tip") return {"shape"};
    if (section == "exchange") return {"absorbs"};
    return {};
}

std::vector<std::string_view> known_sections(ToolKind kind) {
    std::vector<std::string_view> sections = {"version", "kind", "units", "name", "dips", "dynamics"};
    for (const PresetField& field : preset_fields()) {
        if (applies_to(field, kind)) sections.push_back(field.section);
    }
    return sections;
}

/// Reads the numbers of one section; one that tools of this kind do not have is left out.
void read_numbers(const Section& root, std::string_view section_name, int version, Preset& preset) {
    std::vector<std::string_view> keys = other_keys(section_name, preset.kind);
    std::vector<const PresetField*> fields;
    for (const PresetField& field : preset_fields()) {
        if (field.section != section_name || !applies_to(field, preset.kind) || field.since > version)
            continue;
        fields.push_back(&field);
        keys.push_back(field.key);
    }
    if (fields.empty()) return;
    const Section section = root.section(section_name);
    section.check_fields(keys);
    for (const PresetField* field : fields) {
        const Range range = {field->low, field->high};
        field->set(preset, field->whole ? section.whole_number(field->key, range)
                                        : section.number(field->key, range));
    }
}

void check_drop_count(const Section& root, const DropletPreset& droplets) {
    if (droplets.rate_mm3_s <= kMostDrops_per_s * droplets.drop_mm3) return;
    const Section section = root.section("droplets");
    section.fail(section.path_of("drop"),
                 "%1 is %2, so that more than 100000 drops a second would fall.",
                 text_of(droplets.drop_mm3));
}

void read_tip_shape(const Section& root, Preset& preset) {
    const Section tip = root.section("tip");
    preset.tip.shape = tip.choice("shape", kShapeNames);
    if (preset.tip.point_mm > preset.tip.length_mm) {
        tip.fail(tip.path_of("point"), "%1 is %2, more than the length, %3.",
                 text_of(preset.tip.point_mm), text_of(preset.tip.length_mm));
    }
}

std::vector<CurvePoint> read_points(const Section& curve) {
    const Json& list = curve.list("curve");
    const std::string path = curve.path_of("curve");
    if (list.empty() || list.size() > kMostCurvePoints) {
        curve.fail(path, "%1 must have 1 to %2 points, not %3.", kMostCurvePoints, list.size());
    }
    std::vector<CurvePoint> points;
    for (const Json& point : list) {
        const std::string where = path + "[" + std::to_string(points.size()) + "]";
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number()) {
            curve.fail(where, "%1 must be two numbers, not %2.", point.dump());
        }
        points.push_back({point[0].get<double>(), point[1].get<double>()});
        if (points.size() > 1 && points.back().input <= points[points.size() - 2].input) {
            curve.fail(where, "%1 is %2, whose input is not above that of the point before it.",
                       point.dump());
        }
    }
    return points;
}

void check_pair(const Section& section, const DynamicsCurve& curve) {
    if (can_set(curve.input, curve.target)) return;
    section.fail(section.path_of("input"), "%1 is \"%2\", which cannot set \"%3\".",
                 section.text("input"), section.text("target"));
}

std::vector<DynamicsCurve> read_dynamics(const Json& list, const core::Message& file) {
    std::vector<DynamicsCurve> curves;
    for (const Json& entry : list) {
        const Section section(entry, file, "dynamics[" + std::to_string(curves.size()) + "]");
        section.check_fields({"input", "target", "curve"});
        curves.push_back({section.choice("input", kInputNames), section.choice("target", kTargetNames),
                          read_points(section)});
        check_pair(section, curves.back());
    }
    return curves;
}

Json parse_json(std::string_view text, const core::Message& file) {
    core::check_json_depth(text, file.text());
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw core::InputError("%1, line %2: this is not valid JSON.", file,
                               1 + std::count(text.begin(), end, '\n'));
    } catch (const Json::exception& error) {
        throw core::InputError("%1: holds a number that is too large (%2).", file, error.what());
    }
}

}  // namespace

Preset parse_preset(std::string_view json_text, const core::Message& place) {
    const Json json = parse_json(json_text, place);
    const Section root(json, place, "");
    constexpr int kOldestRead = 2;
    const auto version = static_cast<int>(root.whole_number("version", {kOldestRead, kPresetVersion}));
    Preset preset;
    preset.kind = root.choice("kind", kKindNames);
    root.check_fields(known_sections(preset.kind));
    check_units(root.section("units"));
    preset.name = root.text("name");
    if (preset.name.empty()) root.fail(root.path_of("name"), "%1 is empty.");
    preset.dips = root.truth("dips");
    for (const std::string_view section : kPresetSections)
        read_numbers(root, section, version, preset);
    if (preset.kind == ToolKind::Contact) {
        read_tip_shape(root, preset);
        preset.exchange.absorbs = root.section("exchange").truth("absorbs");
    }
    if (preset.kind == ToolKind::Droplets) check_drop_count(root, preset.droplets);
    preset.stroke.jitter_seed = root.section("stroke").choice("jitter_seed", kJitterSeedNames);
    preset.dynamics = read_dynamics(root.list("dynamics"), place);
    return preset;
}

}  // namespace pastoso::brush
