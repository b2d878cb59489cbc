// Hues that go together, by their places on the wheel.
#pragma once

#include <array>
#include <vector>

namespace pastoso::tools {

enum class Harmony { None, Complementary, SplitComplementary, Analogous, Triad, Tetrad };

/// As files name them, in their order.
inline constexpr std::array<const char*, 6> kHarmonyNames = {
    "none", "complementary", "split complementary", "analogous", "triad", "tetrad"};

/// The hues that go with `hue_deg`, from 0 to 360, itself left out; in the order of the wheel from
/// there. Opposite for complementary; 150 and 210 degrees on for split complementary, 30 to both sides
/// for analogous, thirds for a triad, quarters for a tetrad.
std::vector<double> harmony_hues(Harmony harmony, double hue_deg);

/// Whether a hue is `base_deg` or one that goes with it, to two degrees: less is not seen, and lost
/// where a colour is rounded to what a screen shows.
bool in_harmony(Harmony harmony, double base_deg, double hue_deg);

}  // namespace pastoso::tools
