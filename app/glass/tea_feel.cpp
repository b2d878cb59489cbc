#include "glass/tea_feel.hpp"

namespace pastoso::glass {
namespace {

using S = liquid::TeaSettings;
using tools::FeelScale;
using Number = tools::FeelNumber<S>;

// The usual glass stands in the middle of the first three, and at the hot end of the last.

/// Milk that is no colder than the tea is lifted by its fat: it spreads under the surface. The coldest
/// falls to the floor at once.
constexpr Number kWarmToCold[] = {{&S::cold_m_s2, 0.14, 1.1, FeelScale::Linear}};

/// Fat lifts. Cream holds together in large soft bodies; thin milk breaks into small ones that mix and
/// dissolve soon.
constexpr Number kThinToCreamy[] = {{&S::fat_m_s2, 0.15, 0.6, FeelScale::Logarithmic},
                                    {&S::milk_diffusion_m2_s, 9e-5, 1e-5, FeelScale::Logarithmic},
                                    {&S::ball_radius_m, 0.0044, 0.0099, FeelScale::Logarithmic},
                                    {&S::dissolving_s, 4.7, 42.0, FeelScale::Logarithmic}};

/// From high it arrives fast: it stirs the tea, and the whole glass turns cloudy.
constexpr Number kLowToHigh[] = {{&S::pour_height_m, 0.0005, 0.05, FeelScale::Logarithmic}};

/// In ice-cold tea milk does not warm, so nothing lifts it: it lies where it fell, and dissolves slowly.
constexpr Number kHotToIceCold[] = {{&S::fast_warming_s, 0.5, 30.0, FeelScale::Logarithmic},
                                    {&S::slow_warming_s, 400.0, 4000.0, FeelScale::Logarithmic},
                                    {&S::chill_share, 0.25, 0.0, FeelScale::Linear},
                                    {&S::first_ball_s, 3.4, 30.0, FeelScale::Linear},
                                    {&S::dissolving_at_rest_s, 240.0, 900.0, FeelScale::Logarithmic},
                                    {&S::rest_ends_s, 22.0, 90.0, FeelScale::Linear}};

}  // namespace

std::span<const Number> numbers_of(TeaFeel feel) {
    switch (feel) {
        case TeaFeel::WarmToColdMilk:
            return kWarmToCold;
        case TeaFeel::ThinToCreamy:
            return kThinToCreamy;
        case TeaFeel::PouredLowToHigh:
            return kLowToHigh;
        case TeaFeel::HotToIceColdTea:
            break;
    }
    return kHotToIceCold;
}

S with_place(S settings, TeaFeel feel, double place) {
    return tools::feel_moved(settings, numbers_of(feel), place);
}

}  // namespace pastoso::glass
