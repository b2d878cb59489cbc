// What kind of tool it is: the numbers of a preset file, in its own terms and units.
#pragma once

#include "core/message.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::brush {

/// What a tool does when the pen comes down.
enum class ToolKind {
    Contact,   ///< a tip of many elements touches the canvas: brushes, knives, combs, rags, fingers
    Droplets,  ///< drops fall, or are sprayed or flicked, over the width of the tip
    Air,       ///< a jet of air as wide as the tip pushes wet paint
};

enum class TipShape {
    Round,
    Flat,
    Filbert,
    Fan,
    Knife,  ///< a row of stiff elements without gaps
    Comb,   ///< a row of stiff teeth
    Pad,    ///< a soft disc or cloth without hairs, or a fingertip: width by thickness
    Nib     ///< a short stiff edge that is fed from behind: a pen
};
std::string_view name_of(TipShape shape);

/// Whether its elements stand side by side along a stiff edge.
bool is_row(TipShape shape);

/// The tip at rest, in the frame of the ferrule: x along its width, y along its thickness.
struct TipPreset {
    TipShape shape = TipShape::Flat;
    double width_mm = 20.0;      ///< 0.5 to 200
    double thickness_mm = 4.8;   ///< 0.1 to 200; a round tip is as thick as it is wide
    double length_mm = 22.0;     ///< of the free hairs, 1 to 400
    double point_mm = 0.0;       ///< how much shorter the outermost hairs of a round or filbert are
    int bristles = 300;          ///< elements the tip is made of, 4 to 2000
    int hairs_per_bristle = 16;  ///< fine streaks within one element, 1 to 64
    std::uint32_t seed = 1;
    double tooth = 0.6;     ///< width of a comb's tooth, in distances of its teeth; 0.02 to 1
    double pores_mm = 0.0;  ///< depth of a sponge's pores; 0 to 100
    /// Way round a roller, whose elements lie all round it; 0: it does not roll; at most 1000.
    double girth_mm = 0.0;
    friend bool operator==(const TipPreset&, const TipPreset&) = default;
};

struct FlexPreset {
    double bend = 0.5;    ///< sideways reach of a bent hair, share of the inextensible arc; 0 to 1
    double splay = 0.22;  ///< how far the hairs spread at full pressure, share of their place; 0 to 3
    double lag = 1.0;     ///< length of the trail behind a turn, in 0.6 hair lengths; 0.05 to 20
    double press_depth = 0.32;  ///< ferrule's travel at full pressure, hair lengths; 0.01 to 0.9
    double tilt_gain = 0.8;     ///< how much a lean lowers one side; 0 to 3
    double descend = 0.35;      ///< slope at which a hair follows the support down; 0 to 10
    double rigidity = 0.0;      ///< 0: every hair for itself, 1: one stiff edge
    double ride = 0.0;          ///< how far wet paint carries it, off the ground; 0 to 1
    friend bool operator==(const FlexPreset&, const FlexPreset&) = default;
};

struct PaintPreset {
    double film_mm = 0.22;  ///< wet film that a full, lightly pressed brush leaves; 0.001 to 3
    double run_mm = 160.0;  ///< length of stroke that a full load lasts; 1 to 10000
    double groove = 0.5;    ///< ridges between bristles, in films; 0 to 3
    double hair = 0.35;     ///< streaks of single hairs, in films; 0 to 5
    double streak = 0.75;   ///< difference from bristle to bristle; 0 to 1
    double gather = 0.0;    ///< how far each dip gathers the hairs anew; 0 to 1
    double edge = 0.7;      ///< extra film along the edges of the stroke; 0 to 3
    double start = 0.5;     ///< extra film where the stroke starts; 0 to 5
    double leave = 0.0;     ///< share of the load that stays behind on lifting; 0 to 1
    double reach = 1.15;    ///< depth that hanging paint bridges, in films; 0.1 to 50
    double coat = 0.0;      ///< 0: levels the hollows that it reaches, 1: coats the grain alone
    friend bool operator==(const PaintPreset&, const PaintPreset&) = default;
};

struct ExchangePreset {
    double pickup = 0.35;    ///< share of the paint in the way that is taken up; 0 to 1
    double mix = 0.3;        ///< equal-volume swap with the paint below; 0 to 1
    double wick = 0.06;      ///< exchange between neighbouring bristles per mm of travel; 0 to 1
    double momentum = 0.5;   ///< drags runny paint along, ploughs stiff paint aside; 0 to 1
    double overflow = 1.15;  ///< fill above which paint is pushed out sideways; 1 to 3
    /// What is taken up is thrown away, as by a rag: it counts as waste and never comes back.
    bool absorbs = false;
    friend bool operator==(const ExchangePreset&, const ExchangePreset&) = default;
};

/// Drops of a dropper, a spray can or a flicked brush.
struct DropletPreset {
    double drop_mm3 = 1.0;         ///< mean volume of a drop; 1e-5 to 1000
    double variation = 0.0;        ///< 0: all alike, 1: from a hundredth of the mean to several times it
    double rate_mm3_s = 0.0;       ///< paint let go while the pen is down; 0 to 10000
    double touch_mm3 = 0.0;        ///< a drop let go when the pen comes down; 0 to 1000
    double capacity_mm3 = 1000.0;  ///< of the bottle; 0.1 to 1e6
    double steepness = 0.3;        ///< height over radius of a drop that has landed; 0.02 to 2
    double centring = 0.0;         ///< 0: evenly over the width, 1: thickest in the middle
    double throw_s = 0.0;          ///< time that drops fly on with the speed of the tip; 0 to 2
    friend bool operator==(const DropletPreset&, const DropletPreset&) = default;
};

/// A jet of air as wide as the tip (film/air_jet.hpp), which leans with the pen.
struct AirPreset {
    double pressure_Pa = 20.0;  ///< in its middle at full pressure of the pen; 0 to 2000
    friend bool operator==(const AirPreset&, const AirPreset&) = default;
};

enum class JitterSeed {
    Stroke,
    Brush
};  ///< small random choices differ from stroke to stroke, or never do

struct StrokePreset {
    double spacing = 0.4;          ///< substep, in radii of the footprint of one element; 0.1 to 1
    double min_spacing_mm = 0.06;  ///< 0.02 to 2
    double smoothing_ms = 10.0;    ///< time constant of the pen filter; 0 to 200
    double string_mm = 0.0;        ///< length of the string that pulls the brush, 0 for none; 0 to 50
    JitterSeed jitter_seed = JitterSeed::Stroke;
    friend bool operator==(const StrokePreset&, const StrokePreset&) = default;
};

/// What a curve reads.
enum class DynamicsInput {
    Pressure,        ///< 0 to 1
    Tilt,            ///< from upright, 0 to 90 degrees
    BarrelRotation,  ///< 0 to 360 degrees
    Speed,           ///< of the tip, mm/s
    Direction,       ///< of travel, clockwise from the right, 0 to 360 degrees
    Distance,        ///< that the tip has travelled since it came down, mm
    Time,            ///< since the pen came down, s
    Fade,            ///< the distance in widths of the tip
    StrokeRandom,    ///< another number in every stroke, 0 to 1
    DabRandom,       ///< another one every half width of the tip, and smoothly on to it, 0 to 1
    Wheel,           ///< of an airbrush, 0 turned back to 1 forward, 0.5 without one
    Load             ///< what the tool still holds, of what it can hold, 0 to 1 and above
};

/// What it sets: Press is how far the brush is pressed down (0-1), Lean how far it leans (1 shifts the
/// hairs by their reach), Rotation an angle in degrees. The others multiply the number of that name:
/// Flow the rate of droplets or the strength of the air, Spread the width that they reach, Ride how far
/// wet paint carries the tool.
enum class DynamicsTarget { Press, Lean, Rotation, Reach, Film, Pickup, Flow, Spread, Ride };

/// Whether a curve may lead from the input to the target: a lean is a length along the tilt, and only
/// that can give it.
inline constexpr bool can_set(DynamicsInput input, DynamicsTarget target) {
    return target != DynamicsTarget::Lean || input == DynamicsInput::Tilt;
}

struct CurvePoint {
    double input = 0.0, output = 0.0;
    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// Piecewise linear between its points, constant beyond the first and last; inputs increase.
struct DynamicsCurve {
    DynamicsInput input = DynamicsInput::Pressure;
    DynamicsTarget target = DynamicsTarget::Press;
    std::vector<CurvePoint> points;
    friend bool operator==(const DynamicsCurve&, const DynamicsCurve&) = default;
};

/// A contact tool uses all but droplets and air; the others use the tip's width and seed, their own
/// section, the stroke and the curves.
struct Preset {
    std::string name;
    ToolKind kind = ToolKind::Contact;
    /// Whether a painter fills it with paint before use; a rag or a comb is used as it is.
    bool dips = true;
    TipPreset tip;
    FlexPreset flex;
    PaintPreset paint;
    ExchangePreset exchange;
    StrokePreset stroke;
    std::vector<DynamicsCurve> dynamics;
    DropletPreset droplets;
    AirPreset air;
    friend bool operator==(const Preset&, const Preset&) = default;
};

/// Reads one preset (resources/brushes/*.json show the form; docs/brush-format.md).
/// `place`, as the file's name, is for errors only. Throws InputError that names it, the field (as in
/// "paint.film") and its value: a field that is missing, unknown, of the wrong type or out of the range
/// above.
Preset parse_preset(std::string_view json_text, const core::Message& place);
inline Preset parse_preset(std::string_view json_text, const std::string& file_name) {
    return parse_preset(json_text, core::Message::verbatim(file_name));
}

/// The preset as a file, as parse_preset() reads it back.
std::string preset_to_json(const Preset& preset);

/// The presets that come with the program, in the order of their file names.
const std::vector<Preset>& bundled_presets();

/// The bundled preset of that name, or the one that a single word means ("flat", "round", "mop",
/// "knife", "rag", "spray", "blow" ...), upper and lower case alike. Throws InputError that lists the
/// names there are.
const Preset& find_preset(std::string_view name);

/// The same kind of brush with a tip `width_mm` wide (0: as it is): thickness, length and point grow in
/// proportion, and the number of bristles with the area they fill (that of an edge or a roller, whose
/// girth stays, with its width), so that a bristle's footprint keeps its measure: down to 30 if the
/// preset has them, and up to 250, or as many as it has, which bounds the cost. What an edge leaves
/// where it lifts, as long as it is thick, grows in proportion as well, since a full load lasts as long
/// on any width.
Preset resized(const Preset& preset, double width_mm);

}  // namespace pastoso::brush
