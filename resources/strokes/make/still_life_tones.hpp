// The colours of the still life, from the darkest tone of every thing to its lightest.
#pragma once

#include "painter.hpp"

#include <string>
#include <vector>

namespace pastoso::examples {

using Paints = std::vector<document::LoadPaint>;
using Tones = std::vector<std::string>;

extern const Tones kWallTones;
extern const Tones kClothTones;
extern const Tones kGreenPearTones;
extern const Tones kRipePearTones;
extern const Tones kLemonTones;
extern const Tones kAppleTones;
extern const Tones kBowlTones;
extern const std::string kContactShadow;

/// Neighbouring tones half-mixed on the brush, so that no two strokes are the same colour.
Paints half_mixed(const Tones& tones);

}  // namespace pastoso::examples
