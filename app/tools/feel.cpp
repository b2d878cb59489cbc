#include "tools/feel.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::tools {
namespace {

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

}  // namespace

double feel_place(double value, double from, double to, FeelScale scale) {
    const double begin = on_scale(from, scale), end = on_scale(to, scale);
    return std::clamp((on_scale(value, scale) - begin) / (end - begin), 0.0, 1.0);
}

double feel_moved(double value, double from, double to, FeelScale scale, double place, double next) {
    const bool forth = next > place;
    const double way = forth ? (next - place) / (1.0 - place) : (place - next) / place;
    const double end = forth ? to : from;
    if (way >= 1.0) return end;
    return off_scale(std::lerp(on_scale(value, scale), on_scale(end, scale), way), scale);
}

}  // namespace pastoso::tools
