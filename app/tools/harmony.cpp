#include "tools/harmony.hpp"

#include "tools/colour_models.hpp"

#include <algorithm>

namespace pastoso::tools {
namespace {

constexpr double kSame_deg = 2.0;

std::vector<double> steps_deg(Harmony harmony) {
    switch (harmony) {
        case Harmony::Complementary:
            return {180.0};
        case Harmony::SplitComplementary:
            return {150.0, 210.0};
        case Harmony::Analogous:
            return {30.0, 330.0};
        case Harmony::Triad:
            return {120.0, 240.0};
        case Harmony::Tetrad:
            return {90.0, 180.0, 270.0};
        case Harmony::None:
            break;
    }
    return {};
}

bool is_same(double first_deg, double second_deg) {
    const double apart_deg = turned_deg(first_deg - second_deg);
    return std::min(apart_deg, 360.0 - apart_deg) <= kSame_deg;
}

}  // namespace

std::vector<double> harmony_hues(Harmony harmony, double hue_deg) {
    std::vector<double> hues = steps_deg(harmony);
    for (double& hue : hues)
        hue = turned_deg(hue + hue_deg);
    return hues;
}

bool in_harmony(Harmony harmony, double base_deg, double hue_deg) {
    const std::vector<double> hues = harmony_hues(harmony, base_deg);
    return is_same(base_deg, hue_deg) ||
           std::any_of(hues.begin(), hues.end(), [&](double hue) { return is_same(hue, hue_deg); });
}

}  // namespace pastoso::tools
