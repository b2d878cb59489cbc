// What paint looks like where the painter stands: the colours of the window's swatches.
#pragma once

#include "brush/load_profile.hpp"
#include "document/events.hpp"
#include "film/medium.hpp"
#include "shade/spot.hpp"
#include "tools/hand.hpp"

#include <optional>
#include <string>

namespace pastoso::tools {

/// As which spot swatches show their paint: of what is in hand, on the canvas that stands there, in its
/// light.
struct SwatchView {
    shade::Spot spot;
    film::Medium medium;  ///< that recipes are mixed in
    friend bool operator==(const SwatchView&, const SwatchView&) = default;
};

/// The film that the tool in hand lays, mm; of one that is not dipped, or lays none, the film that the
/// medium is usually painted in.
double film_in_hand_mm(const Hand& hand);

/// The colour that a flat spot of the paint has on the canvas: of paint as a brush holds it, or of a
/// recipe.
pigment::Srgb8 swatch_colour(const film::PaintCoefficients& paint, const SwatchView& view);
pigment::Srgb8 swatch_colour(const document::PaintRecipe& paint, const SwatchView& view);

/// A flat spot of paint, and the share that it hides of what lies below: 1 less what it shows brighter
/// over white than over black, against white, in the mean of its encoded channels.
struct WetColour {
    pigment::Srgb8 colour{};
    double opacity = 1.0;
    friend bool operator==(const WetColour&, const WetColour&) = default;
};
WetColour wet_colour(const film::PaintCoefficients& paint, const SwatchView& view);
WetColour wet_colour(const document::PaintRecipe& paint, const SwatchView& view);

/// Of all that is in a brush, fainter where it runs dry; nothing where that is hardly anything.
std::optional<WetColour> wet_colour(const brush::LoadProfile& load, const SwatchView& view);

/// The paint of the tube of that Colour Index name, the clear medium for none, and one part of it in
/// four of titanium white, where a dark pigment shows its hue.
document::PaintRecipe tube_paint(const std::string& ci_name);
document::PaintRecipe tube_tint(const std::string& ci_name);

/// What stands among colours of a screen for paint that has no colour of its own.
inline constexpr pigment::Srgb8 kClearMedium = {232, 230, 224};

/// The colour of a screen, whose white stands for titanium white, that colour_paint() makes this paint's
/// colour of, in daylight and thick.
pigment::Srgb8 screen_colour(const document::PaintRecipe& paint);

}  // namespace pastoso::tools
