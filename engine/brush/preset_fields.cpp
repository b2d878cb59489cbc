#include "brush/preset_fields.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace pastoso::brush {
namespace {

template <auto kPart, auto kNumber>
double get(const Preset& preset) {
    return static_cast<double>(preset.*kPart.*kNumber);
}

template <auto kPart, auto kNumber>
void set(Preset& preset, double value) {
    auto& number = preset.*kPart.*kNumber;
    number = static_cast<std::remove_reference_t<decltype(number)>>(value);
}

struct Range {
    double low, high;
};

template <auto kPart, auto kNumber>
constexpr PresetField row(std::string_view section, std::string_view key, std::string_view unit,
                          Range range, std::string_view meaning, int since) {
    using Part = std::remove_reference_t<decltype(Preset{}.*kPart)>;
    constexpr bool kWhole = std::is_integral_v<std::remove_reference_t<decltype(Part{}.*kNumber)>>;
    return {section, key,     unit,  range.low,           range.high,
            kWhole,  meaning, since, get<kPart, kNumber>, set<kPart, kNumber>};
}

template <auto kNumber>
constexpr PresetField tip(std::string_view key, std::string_view unit, Range range,
                          std::string_view meaning, int since = 2) {
    return row<&Preset::tip, kNumber>("tip", key, unit, range, meaning, since);
}
template <auto kNumber>
constexpr PresetField flex(std::string_view key, std::string_view unit, Range range,
                           std::string_view meaning, int since = 2) {
    return row<&Preset::flex, kNumber>("flex", key, unit, range, meaning, since);
}
template <auto kNumber>
constexpr PresetField paint(std::string_view key, std::string_view unit, Range range,
                            std::string_view meaning, int since = 2) {
    return row<&Preset::paint, kNumber>("paint", key, unit, range, meaning, since);
}
template <auto kNumber>
constexpr PresetField exchange(std::string_view key, std::string_view unit, Range range,
                               std::string_view meaning, int since = 2) {
    return row<&Preset::exchange, kNumber>("exchange", key, unit, range, meaning, since);
}
template <auto kNumber>
constexpr PresetField stroke(std::string_view key, std::string_view unit, Range range,
                             std::string_view meaning, int since = 2) {
    return row<&Preset::stroke, kNumber>("stroke", key, unit, range, meaning, since);
}
template <auto kNumber>
constexpr PresetField droplets(std::string_view key, std::string_view unit, Range range,
                               std::string_view meaning, int since = 2) {
    return row<&Preset::droplets, kNumber>("droplets", key, unit, range, meaning, since);
}
template <auto kNumber>
constexpr PresetField air(std::string_view key, std::string_view unit, Range range,
                          std::string_view meaning, int since = 2) {
    return row<&Preset::air, kNumber>("air", key, unit, range, meaning, since);
}

constexpr PresetField kFields[] = {
    tip<&TipPreset::width_mm>("width", "mm", {0.5, 200.0}, "Width of the tip."),
    tip<&TipPreset::thickness_mm>("thickness", "mm", {0.1, 200.0},
                                  "Thickness of the tip; a round one is as thick as it is wide."),
    tip<&TipPreset::length_mm>("length", "mm", {1.0, 400.0}, "Length of the free hairs."),
    tip<&TipPreset::point_mm>("point", "mm", {0.0, 400.0},
                              "How much shorter the outermost hairs are; at most the length."),
    tip<&TipPreset::bristles>("bristles", "", {4.0, 2000.0}, "Elements that the tip is made of."),
    tip<&TipPreset::hairs_per_bristle>("hairs_per_bristle", "", {1.0, 64.0},
                                       "Fine streaks within one element."),
    tip<&TipPreset::seed>("seed", "", {0.0, 1e9}, "Makes one piece differ from the next."),
    tip<&TipPreset::tooth>("tooth", "", {0.02, 1.0},
                           "Width of a comb's tooth, in distances of its teeth.", 5),
    tip<&TipPreset::pores_mm>("pores", "mm", {0.0, 100.0}, "Depth of a sponge's pores.", 5),
    tip<&TipPreset::girth_mm>(
        "girth", "mm", {0.0, 1000.0},
        "Way round a roller, after which its mark comes again; 0: it does not roll.", 5),

    flex<&FlexPreset::bend>("bend", "", {0.0, 1.0}, "How far a bent hair trails behind the hand."),
    flex<&FlexPreset::splay>("splay", "", {0.0, 3.0}, "How far the hairs spread at full pressure."),
    flex<&FlexPreset::lag>("lag", "", {0.05, 20.0}, "How long the hairs trail after a turn."),
    flex<&FlexPreset::press_depth>("press_depth", "", {0.01, 0.9},
                                   "Way of the ferrule at full pressure, in hair lengths."),
    flex<&FlexPreset::tilt_gain>("tilt_gain", "", {0.0, 3.0}, "How much a lean lowers one side."),
    flex<&FlexPreset::descend>("descend", "", {0.0, 10.0},
                               "How steeply hairs follow the weave down: little gives dry brush."),
    flex<&FlexPreset::rigidity>("rigidity", "", {0.0, 1.0},
                                "0: every hair for itself, 1: one stiff edge."),
    flex<&FlexPreset::ride>("ride", "", {0.0, 1.0},
                            "How far wet paint carries it in a light hand, off the ground.", 4),

    paint<&PaintPreset::film_mm>("film", "mm", {0.001, 3.0}, "Wet film that a full brush leaves."),
    paint<&PaintPreset::run_mm>("run", "mm", {1.0, 10000.0}, "Stroke that a full load lasts."),
    paint<&PaintPreset::groove>("groove", "", {0.0, 3.0}, "Ridges between bristles, in films."),
    paint<&PaintPreset::hair>("hair", "", {0.0, 5.0}, "Streaks of single hairs, in films."),
    paint<&PaintPreset::streak>("streak", "", {0.0, 1.0}, "Difference from bristle to bristle."),
    paint<&PaintPreset::gather>("gather", "", {0.0, 1.0},
                                "How far each dip gathers the hairs anew; 0: never.", 3),
    paint<&PaintPreset::edge>("edge", "", {0.0, 3.0}, "Extra film along the edges, in films."),
    paint<&PaintPreset::start>("start", "", {0.0, 5.0}, "Extra film where the stroke starts."),
    paint<&PaintPreset::leave>("leave", "", {0.0, 1.0}, "Share of the load that stays on lifting."),
    paint<&PaintPreset::reach>("reach", "", {0.1, 50.0}, "Depth that hanging paint bridges, in films."),
    paint<&PaintPreset::coat>("coat", "", {0.0, 1.0},
                              "0: levels the hollows that it reaches, 1: coats the grain alone.", 5),

    exchange<&ExchangePreset::pickup>("pickup", "", {0.0, 1.0},
                                      "Share of the paint in the way that is taken up."),
    exchange<&ExchangePreset::mix>("mix", "", {0.0, 1.0}, "How fast it mixes with the paint below."),
    exchange<&ExchangePreset::wick>("wick", "1/mm", {0.0, 1.0}, "Exchange between neighbouring hairs."),
    exchange<&ExchangePreset::momentum>("momentum", "", {0.0, 1.0},
                                        "How far a fast stroke drags paint along and ploughs it aside."),
    exchange<&ExchangePreset::overflow>("overflow", "", {1.0, 3.0},
                                        "Fill above which paint is pushed out sideways."),

    stroke<&StrokePreset::spacing>("spacing", "", {0.1, 1.0}, "Step, in radii of an element."),
    stroke<&StrokePreset::min_spacing_mm>("min_spacing", "mm", {0.02, 2.0}, "Least step."),
    stroke<&StrokePreset::smoothing_ms>("smoothing_ms", "ms", {0.0, 200.0},
                                        "Time over which the hand is steadied."),
    stroke<&StrokePreset::string_mm>("string_mm", "mm", {0.0, 50.0},
                                     "Length of the string that pulls the tip."),

    droplets<&DropletPreset::drop_mm3>("drop", "mm3", {1e-5, 1000.0}, "Mean volume of a drop."),
    droplets<&DropletPreset::variation>("variation", "", {0.0, 1.0}, "How much drops differ."),
    droplets<&DropletPreset::rate_mm3_s>("rate", "mm3/s", {0.0, 10000.0},
                                         "Paint let go while the pen is down."),
    droplets<&DropletPreset::touch_mm3>("touch", "mm3", {0.0, 1000.0},
                                        "A drop let go when the pen comes down."),
    droplets<&DropletPreset::capacity_mm3>("capacity", "mm3", {0.1, 1e6}, "What the bottle holds."),
    droplets<&DropletPreset::steepness>("steepness", "", {0.02, 2.0},
                                        "Height over radius of a drop that has landed."),
    droplets<&DropletPreset::centring>("centring", "", {0.0, 1.0},
                                       "0: evenly over the width, 1: thickest in the middle."),
    droplets<&DropletPreset::throw_s>("throw", "s", {0.0, 2.0},
                                      "Time that drops fly on with the speed of the tip."),

    air<&AirPreset::pressure_Pa>("pressure", "Pa", {0.0, 2000.0}, "Pressure in the middle of the jet."),
};

}  // namespace

std::span<const PresetField> preset_fields() {
    return kFields;
}

Preset with_number(Preset preset, const PresetField& field, double value) {
    const double within = std::clamp(value, field.low, field.high);
    field.set(preset, field.whole ? std::round(within) : within);
    const auto is = [&](std::string_view section, std::string_view key) {
        return field.section == section && field.key == key;
    };
    TipPreset& tip = preset.tip;
    if (is("tip", "point")) tip.length_mm = std::max(tip.length_mm, tip.point_mm);
    tip.point_mm = std::min(tip.point_mm, tip.length_mm);
    DropletPreset& drops = preset.droplets;
    if (is("droplets", "rate"))
        drops.drop_mm3 = std::max(drops.drop_mm3, drops.rate_mm3_s / kMostDrops_per_s);
    drops.rate_mm3_s = std::min(drops.rate_mm3_s, kMostDrops_per_s * drops.drop_mm3);
    return preset;
}

Preset within_ranges(Preset preset) {
    for (const PresetField& field : kFields)
        field.set(preset, std::clamp(field.get(preset), field.low, field.high));
    return preset;
}

bool applies_to(const PresetField& field, ToolKind kind) {
    if (field.section == "stroke") return true;
    if (field.section == "droplets") return kind == ToolKind::Droplets;
    if (field.section == "air") return kind == ToolKind::Air;
    const bool of_every_tip = field.section == "tip" && (field.key == "width" || field.key == "seed");
    return kind == ToolKind::Contact || of_every_tip;
}

}  // namespace pastoso::brush
