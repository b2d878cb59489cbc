// Paint drawn out from a thick film to a thin one over white and over black, as colour charts show how
// well it hides.
#pragma once

#include "pigment/hiding.hpp"
#include "tools/swatch.hpp"

#include <array>

namespace pastoso::tools {

struct Drawdown {
    static constexpr int kSteps = 8;

    /// The film in hand first; the last has the share pigment::kDrawnOut of it, and all are in equal
    /// proportion to the one before.
    std::array<pigment::Srgb8, kSteps> over_white{}, over_black{};
    pigment::Hiding hiding = pigment::Hiding::Transparent;  ///< of the film in hand
    friend bool operator==(const Drawdown&, const Drawdown&) = default;
};

/// White is opaque titanium white, black lets nothing back.
Drawdown drawdown(const document::PaintRecipe& paint, const SwatchView& view);

/// The grade alone.
pigment::Hiding hiding_of(const document::PaintRecipe& paint, const SwatchView& view);

}  // namespace pastoso::tools
