// What one says of milk and tea before one knows any number: warm or cold, thin or creamy,
// poured low or from high.
#pragma once

#include "liquid/tea/tea_settings.hpp"
#include "tools/feel.hpp"

#include <span>

namespace pastoso::glass {

enum class TeaFeel { WarmToColdMilk, ThinToCreamy, PouredLowToHigh, HotToIceColdTea };

/// The numbers that it moves; the first tells where a glass stands.
std::span<const tools::FeelNumber<liquid::TeaSettings>> numbers_of(TeaFeel feel);

/// The glass at another place, as tools::feel_moved(). No other number changes.
liquid::TeaSettings with_place(liquid::TeaSettings settings, TeaFeel feel, double place);

}  // namespace pastoso::glass
