#include "screen/look.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::screen {

bool has_outlines(Look look) {
    return look == Look::Lit || look == Look::Wet || look == Look::Flat;
}

// Even steps of lightness from a dark blue over green to a pale yellow.
const std::array<Rgb, kHeightSteps> kHeightColours{{{0.16F, 0.14F, 0.33F},
                                                    {0.20F, 0.24F, 0.47F},
                                                    {0.17F, 0.36F, 0.54F},
                                                    {0.13F, 0.46F, 0.55F},
                                                    {0.13F, 0.56F, 0.53F},
                                                    {0.22F, 0.66F, 0.47F},
                                                    {0.43F, 0.76F, 0.37F},
                                                    {0.67F, 0.84F, 0.29F},
                                                    {0.88F, 0.90F, 0.35F},
                                                    {0.99F, 0.96F, 0.72F}}};

const Rgb kWetTint{0.10F, 0.72F, 0.95F};

double wet_tint(double wet_mm) {
    if (wet_mm <= kThinnestWet_mm) return 0.0;
    const double share =
        std::log(wet_mm / kThinnestWet_mm) / std::log(kThickestWet_mm / kThinnestWet_mm);
    return kFullTint * std::min(share, 1.0);
}

double scale_top_mm(double highest_mm) {
    constexpr double kLeast_mm = 0.1, kRounding = 1e-9;
    double top_mm = kLeast_mm;
    for (int step = 0; top_mm + kRounding < highest_mm; ++step)
        top_mm *= step % 3 == 1 ? 2.5 : 2.0;
    return top_mm;
}

}  // namespace pastoso::screen
