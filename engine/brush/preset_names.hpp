// The words that preset files use for choices.
#pragma once

#include "brush/preset.hpp"

#include <string_view>

namespace pastoso::brush {

template <class T>
struct Named {
    std::string_view name;
    T value;
};

inline constexpr int kPresetVersion = 5;
inline constexpr std::size_t kMostCurvePoints = 64;

inline constexpr Named<ToolKind> kKindNames[] = {
    {"contact", ToolKind::Contact}, {"droplets", ToolKind::Droplets}, {"air", ToolKind::Air}};
inline constexpr Named<TipShape> kShapeNames[] = {
    {"round", TipShape::Round}, {"flat", TipShape::Flat},   {"filbert", TipShape::Filbert},
    {"fan", TipShape::Fan},     {"knife", TipShape::Knife}, {"comb", TipShape::Comb},
    {"pad", TipShape::Pad},     {"nib", TipShape::Nib}};
inline constexpr Named<JitterSeed> kJitterSeedNames[] = {{"stroke", JitterSeed::Stroke},
                                                         {"brush", JitterSeed::Brush}};
inline constexpr Named<DynamicsInput> kInputNames[] = {
    {"pressure", DynamicsInput::Pressure},
    {"tilt", DynamicsInput::Tilt},
    {"barrel_rotation", DynamicsInput::BarrelRotation},
    {"speed_mm_s", DynamicsInput::Speed},
    {"direction", DynamicsInput::Direction},
    {"distance_mm", DynamicsInput::Distance},
    {"time_s", DynamicsInput::Time},
    {"fade", DynamicsInput::Fade},
    {"stroke_random", DynamicsInput::StrokeRandom},
    {"dab_random", DynamicsInput::DabRandom},
    {"wheel", DynamicsInput::Wheel},
    {"load", DynamicsInput::Load}};
inline constexpr Named<DynamicsTarget> kTargetNames[] = {
    {"press", DynamicsTarget::Press},       {"lean", DynamicsTarget::Lean},
    {"rotation", DynamicsTarget::Rotation}, {"reach", DynamicsTarget::Reach},
    {"film", DynamicsTarget::Film},         {"pickup", DynamicsTarget::Pickup},
    {"flow", DynamicsTarget::Flow},         {"spread", DynamicsTarget::Spread},
    {"ride", DynamicsTarget::Ride}};

/// The word for a value; every value has one.
template <class T, std::size_t N>
std::string_view word_for(T value, const Named<T> (&names)[N]) {
    for (const Named<T>& named : names) {
        if (named.value == value) return named.name;
    }
    return names[0].name;
}

}  // namespace pastoso::brush
