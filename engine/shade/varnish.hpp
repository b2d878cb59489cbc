// A coat of varnish over the whole painting, to look through: it changes what the light does, and no
// paint.
#pragma once

#include "pigment/viewing.hpp"
#include "shade/render.hpp"

namespace pastoso::shade {

enum class Finish { None, Matte, Satin, Gloss };

struct Varnish {
    Finish finish = Finish::None;
    double amount = 1.0;     ///< 0 nothing to 1 a full, even coat
    double yellowing = 0.0;  ///< 0 fresh to 1 a natural resin after about a hundred years
    friend bool operator==(const Varnish&, const Varnish&) = default;
};

/// GGX alpha of a full coat: the surface is the varnish's own, whatever lies below.
double varnish_roughness(Finish finish);

/// The share of the light that comes back through the coat, band by band: once in, once out.
pigment::Bands varnish_transmission(const Varnish& varnish);

/// The light and the viewing that show a painting as it is seen under its varnish. Without a finish, or
/// without an amount, they are what they were, bit for bit. Throws InputError when a value is outside
/// its range.
Lighting varnished(Lighting lighting, const Varnish& varnish);
pigment::Viewing varnished(pigment::Viewing viewing, const Varnish& varnish);

}  // namespace pastoso::shade
