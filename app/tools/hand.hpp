// What the painter holds and has laid out: the choices that outlive a stroke.
#pragma once

#include "brush/preset.hpp"
#include "document/events.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pastoso::tools {

inline constexpr double kSmallestBrush_mm = 1.0;
inline constexpr double kLargestBrush_mm = 200.0;

/// How the brush is dipped.
struct Dip {
    enum class Way {
        Full,      ///< all hairs in one paint
        Tip,       ///< only those that reach deepest
        TwoSides,  ///< one half of the width in each of two paints
        HalfMixed  ///< in both, every hair in another mixture
    };
    Way way = Way::Full;
    double fill = 1.0;          ///< of the brush's capacity, 0.05 to 1.2
    double second_share = 0.5;  ///< of the second paint in a half-mixed load, 0 to 1
    friend bool operator==(const Dip&, const Dip&) = default;
};

struct Hand {
    std::string brush = "Flat bristle 20";
    /// The brush where it is not the bundled one of that name: the painter's own, or changed in hand.
    std::optional<brush::Preset> own_preset;
    double brush_width_mm = 20.0;
    std::optional<document::TakeBrush> brush_aside;  ///< as it was laid there
    document::PaintRecipe paint{{{"PB29", 1.0}}, 1.0};
    document::PaintRecipe second_paint{{{"PW6", 1.0}}, 1.0};  ///< beside the first, for loads of two
    Dip dip;
    document::UseMedium medium{"heavy-body oil"};
    document::TiltCanvas tilt{60.0, 90.0};
    film::DryingAir air;
    brush::Stabiliser stabiliser;
    brush::Symmetry symmetry;
    brush::PenGuide laid;            ///< what lies on the canvas to guide strokes: no straight line
    brush::PenGuide guide;           ///< that the latest stroke had
    bool reload_each_stroke = true;  ///< a clean brush full of `paint` at every touch
    bool turn_with_stroke = true;  ///< a pen that does not tell its rotation turns across its path
    bool tilted = false;           ///< what does not tell its tilt holds the tool aslant

    std::optional<brush::Ruler> ruler() const { return laid_form<brush::Ruler>(); }
    std::optional<brush::EllipseCurve> ellipse() const { return laid_form<brush::EllipseCurve>(); }

  private:
    template <class Form>
    std::optional<Form> laid_form() const {
        const Form* form = std::get_if<Form>(&laid.form);
        return form != nullptr ? std::optional(*form) : std::nullopt;
    }
};

/// The brush in hand, as wide as its preset says.
brush::Preset preset_in_hand(const Hand& hand);

/// The same as wide as it is held.
brush::Preset sized_preset_in_hand(const Hand& hand);

/// The action that takes that brush.
document::TakeBrush taken_of(const Hand& hand, std::uint32_t seed = 1);

/// What the brush is dipped in.
document::LoadPaint load_of(const Hand& hand);

/// What the painter holds after these events, having held `hand` before. Throws InputError for an
/// unknown brush.
Hand hand_after(Hand hand, const std::vector<document::Event>& events);

/// The next width up or down a ladder of handy steps (about 12 %, at least half a millimetre), within
/// the limits.
double stepped_brush_width_mm(double width_mm, int steps);

}  // namespace pastoso::tools
