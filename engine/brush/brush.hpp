// A brush in the painter's hand: its tip and the paint that every bristle holds.
#pragma once

#include "brush/contents.hpp"
#include "brush/preset.hpp"
#include "brush/tip.hpp"
#include "film/cell/consistency.hpp"
#include "film/cell/film_numbers.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace pastoso::brush {

/// How much of the paint in all hairs of a brush is of which medium.
struct HeldMedia {
    std::vector<film::FilmNumbers> numbers;
    std::vector<double> volume_mm3;  ///< of each
    friend bool operator==(const HeldMedia&, const HeldMedia&) = default;
};

/// What a brush is dipped into: one paint, or two at once.
struct MixedLoad {
    film::PaintCoefficients first{}, second{};
    double second_share = 0.0;     ///< mean over the bristles, 0 to 1
    double share_variation = 0.0;  ///< 0: every bristle the same, 1: from all of one to all of the other
    bool side_by_side = false;     ///< one half of the width each, instead of a mean share
    /// Dips only the two fifths of the hairs that reach deepest when the brush is laid on one side; the
    /// others keep what they hold.
    bool tip_only = false;
    /// Of both paints; none: that of the film that the brush comes to.
    std::optional<film::FilmNumbers> medium{};
};

/// Plain data: copy it to keep it. The paint in the bristles, what strokes and loading move, is the
/// account that together with the film stays constant.
struct Brush {
    /// `width_mm` 0 takes the preset's own; brushes of different seeds are different pieces of one kind.
    explicit Brush(const Preset& kind, double width_mm = 0.0, std::uint32_t seed = 1);

    /// Dips the brush: every bristle that holds less than `fill` of what it can take (0 to 1.2; thin
    /// bristles take less) is topped up with paint of these coefficients (each 0 to
    /// kStrongestPaint_per_mm), up to the preset's overflow. Gathers the hairs anew. Returns the paint
    /// taken.
    Contents load(const film::PaintCoefficients& paint, double fill);
    Contents load(const MixedLoad& paint, double fill);

    /// Takes paint off, that share (0 to 1) of what every bristle holds, and returns it. Hairs that keep
    /// some are gathered anew.
    Contents clean(double share = 1.0);

    /// Hands over what an absorbing tool has thrown away since the last call.
    Contents take_thrown_away();

    /// The sum over the bristles.
    Contents contents() const;
    bool holds_paint() const { return contents().volume_mm3 > 0.0; }

    /// What a bristle holds after a full dip (fill 1): thin ones take less.
    double full_dip_mm3(std::size_t bristle) const;

    /// Bristle's volume against its capacity; a full one has 1.
    double fill_of(int bristle) const { return held[bristle].volume_mm3 / tip.capacity_mm3; }

    void gather_hairs();

    /// The hand has travelled so far since the last call: the hairs part again.
    void wear(double travel_mm);

    /// Makes the tip anew from what it follows from.
    void shape_tip();

    Preset preset;  ///< resized
    std::uint32_t piece = 1;  ///< the seed
    Gathering gathering;
    Tip tip;
    std::vector<Contents> held;         ///< one per bristle
    film::Consistencies consistencies;  ///< of what they hold; a brush that holds nothing may name some
    HeldMedia media;                    ///< of paint that was loaded without one it tells nothing
    Contents thrown_away;               ///< by a tool that absorbs; not part of contents()
    std::uint32_t strokes_begun = 0;    ///< seeds what differs from stroke to stroke
};

/// No paint absorbs or scatters more: with film::kMaxThickness_mm it bounds what a cell has to hold.
inline constexpr float kStrongestPaint_per_mm = 1090.0F;

}  // namespace pastoso::brush
