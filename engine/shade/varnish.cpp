// A varnish has nearly the index of the paint's binder, 1.5. Where they meet nothing is reflected, and
// the hollows of the rough paint are filled: what is left is one surface, with the varnish's own
// roughness. On dry paint that surface spreads its 4 % of reflected light over all directions, as a veil
// that lightens darks; a smooth one sends it into the highlight, and elsewhere darks are seen deeper.
// Saunderson's losses (pigment/kubelka_munk.hpp) are those of a smooth surface already: the coat does
// not change them.
//
// With age it takes away blue after Lambert, T^2 = exp(-amount yellowing a), a in each band. The light
// that the surface sends back inside passes the coat again; that is left out, so that the coat is a
// factor on each band's part in what is seen. The a's are such that white reaches the amber of old
// dammar (b* about 33) at 1.

#include "shade/varnish.hpp"

#include "core/error.hpp"

#include <cmath>
#include <string>

namespace pastoso::shade {
namespace {

/// From violet to red.
constexpr std::array<double, pigment::kBands> kAgedAbsorbance = {0.80, 0.42, 0.24, 0.12, 0.06, 0.03};

void check_share(const core::Message& what, double value) {
    if (value >= 0.0 && value <= 1.0) return;
    throw core::InputError("The varnish's %1 is %2, outside the range from 0 to 1.", what,
                           std::to_string(value));
}

/// Of a coat that is there at all.
double coat(const Varnish& varnish) {
    check_share(core::message("amount"), varnish.amount);
    check_share(core::message("yellowing"), varnish.yellowing);
    return varnish.finish == Finish::None ? 0.0 : varnish.amount;
}

}  // namespace

double varnish_roughness(Finish finish) {
    switch (finish) {
        case Finish::Matte:
            return 0.45;
        case Finish::Satin:
            return 0.25;
        case Finish::Gloss:
            return 0.10;
        case Finish::None:
            break;
    }
    return Lighting{}.dry_roughness;
}

pigment::Bands varnish_transmission(const Varnish& varnish) {
    const double depth = coat(varnish) * varnish.yellowing;
    pigment::Bands passed{};
    for (int band = 0; band < pigment::kBands; ++band)
        passed[band] = static_cast<float>(std::exp(-depth * kAgedAbsorbance[band]));
    return passed;
}

Lighting varnished(Lighting lighting, const Varnish& varnish) {
    const double share = coat(varnish);
    if (share == 0.0) return lighting;
    const double roughness = varnish_roughness(varnish.finish);
    lighting.dry_roughness = std::lerp(lighting.dry_roughness, roughness, share);
    lighting.wet_roughness = std::lerp(lighting.wet_roughness, roughness, share);
    return lighting;
}

pigment::Viewing varnished(pigment::Viewing viewing, const Varnish& varnish) {
    if (coat(varnish) == 0.0 || varnish.yellowing == 0.0) return viewing;
    const pigment::Bands passed = varnish_transmission(varnish);
    for (pigment::Bands& weights : viewing.to_rgb)
        for (int band = 0; band < pigment::kBands; ++band)
            weights[band] *= passed[band];
    return viewing;
}

}  // namespace pastoso::shade
