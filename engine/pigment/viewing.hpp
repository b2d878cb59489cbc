// How a painting is looked at: in which light, and in which colour space its picture is made.
#pragma once

#include "pigment/colour.hpp"
#include "pigment/illuminant.hpp"

namespace pastoso::pigment {

/// Changing it changes no paint: pictures are made anew from the same reflectances.
struct Viewing {
    BandsToRgb to_rgb = kBandsToLinearSrgb;
    WorkingSpace space = WorkingSpace::Srgb;
    friend bool operator==(const Viewing&, const Viewing&) = default;
};

/// The viewing in a light, by an eye that is adapted to it: white stays white, and what differs from
/// another light is how the pigments' spectra meet that of the lamp. The matrix is fitted to the
/// light (band_fit.hpp); that for D65 has been fitted once (kBandsToLinearSrgb).
Viewing viewing_under(const Illuminant& light, WorkingSpace space = WorkingSpace::Srgb);

}  // namespace pastoso::pigment
