#include "tools/medium_feel.hpp"

#include "tools/medium_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::tools {
namespace {

using film::Medium;

constexpr FeelNumber kStiffToRunny[] = {{&Medium::viscosity_m2_s, 0.5, 2e-5, FeelScale::Logarithmic},
                                        {&Medium::yield_stress_Pa, 140.0, 0.0, FeelScale::CubeRoot}};

constexpr FeelNumber kShortToLong[] = {{&Medium::advancing_angle_deg, 45.0, 15.0, FeelScale::Linear},
                                       {&Medium::alpha_min, 1.0, 0.8, FeelScale::Linear},
                                       {&Medium::alpha_max, 1.0, 1.2, FeelScale::Linear},
                                       {&Medium::flow_index, 0.7, 1.0, FeelScale::Linear}};

constexpr FeelNumber kOpaqueToTransparent[] = {
    {&Medium::pigment_share, 1.0, 0.01, FeelScale::Logarithmic}};

/// Equal steps of what this gives look alike.
double on_scale(double value, FeelScale scale) {
    switch (scale) {
        case FeelScale::Logarithmic:
            return std::log(value);
        case FeelScale::CubeRoot:
            return std::cbrt(value);
        case FeelScale::Linear:
            break;
    }
    return value;
}

double off_scale(double position, FeelScale scale) {
    switch (scale) {
        case FeelScale::Logarithmic:
            return std::exp(position);
        case FeelScale::CubeRoot:
            return position * position * position;
        case FeelScale::Linear:
            break;
    }
    return position;
}

/// From the value at a place to the number's end on that side.
double moved(const FeelNumber& number, double value, double place, double next) {
    const bool forth = next > place;
    const double way = forth ? (next - place) / (1.0 - place) : (place - next) / place;
    const double end = forth ? number.to : number.from;
    if (way >= 1.0) return end;
    const double scaled = std::lerp(on_scale(value, number.scale), on_scale(end, number.scale), way);
    return off_scale(scaled, number.scale);
}

}  // namespace

std::span<const FeelNumber> numbers_of(Feel feel) {
    switch (feel) {
        case Feel::StiffToRunny:
            return kStiffToRunny;
        case Feel::ShortToLong:
            return kShortToLong;
        case Feel::OpaqueToTransparent:
            break;
    }
    return kOpaqueToTransparent;
}

double place_of(const Medium& medium, Feel feel) {
    const FeelNumber& first = numbers_of(feel).front();
    const double from = on_scale(first.from, first.scale), to = on_scale(first.to, first.scale);
    return std::clamp((on_scale(medium.*first.member, first.scale) - from) / (to - from), 0.0, 1.0);
}

Medium with_place(Medium medium, Feel feel, double place) {
    const double before = place_of(medium, feel), next = std::clamp(place, 0.0, 1.0);
    if (next == before) return medium;
    for (const FeelNumber& number : numbers_of(feel)) {
        const double value = moved(number, medium.*number.member, before, next);
        medium = with_number(std::move(medium), number.member, value);
    }
    return medium;
}

}  // namespace pastoso::tools
