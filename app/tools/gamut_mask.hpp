// A shape on the wheel that colours are chosen within, so that a painting keeps to a few of them
// (Gurney, Color and Light, 2010).
#pragma once

#include "tools/colour_models.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::tools {

enum class MaskShape { None, Triad, AtmosphericTriad, SplitComplementary, Complementary, Circle };

/// As files name them, in their order.
inline constexpr std::array<const char*, 6> kMaskNames = {
    "none", "triad", "atmospheric triad", "split complementary", "complementary", "circle"};

struct GamutMask {
    MaskShape shape = MaskShape::None;
    double turn_deg = 0.0;  ///< of its first corner from hue 0; 0 to 360
    /// Where the painter has moved them, before the turn; empty: the shape's own.
    std::vector<glm::dvec2> corners{};
    friend bool operator==(const GamutMask&, const GamutMask&) = default;
};

/// A colour's place on the disc of hues of its lightness: its hue, 0 to the right and 90 above, and as
/// the radius its saturation, the share that its chroma is of the most that sRGB has there; 0 to 1.
glm::dvec2 disc_place(const Channels& oklch);

/// The colour of that lightness, %, at a place of the disc. Beyond the disc it is that of its rim; in
/// the very middle it has `hue_deg`.
Channels colour_on_disc(double lightness, const glm::dvec2& place, double hue_deg);

/// The mask's corners on the disc, anticlockwise; the shape is convex. None where it is MaskShape::None.
std::vector<glm::dvec2> mask_outline(const GamutMask& mask);

/// How many corners a painter may move: none of a circle.
std::size_t movable_corners(MaskShape shape);

/// Whether they may be corners of the shape: as many, on the disc, anticlockwise and convex.
bool are_corners(const std::vector<glm::dvec2>& corners, MaskShape shape);

/// The mask with that corner of its outline at a place of the disc, or on the rim towards it; as it was
/// where it would not be convex any more.
GamutMask with_corner(const GamutMask& mask, std::size_t corner, const glm::dvec2& place);

/// The place itself where a convex outline holds it, otherwise the nearest on the outline. An empty
/// outline holds everything.
glm::dvec2 held_inside(const std::vector<glm::dvec2>& outline, const glm::dvec2& place);

/// The same for a colour, whose lightness stays.
Channels held_in_mask(const GamutMask& mask, const Channels& oklch);

}  // namespace pastoso::tools
