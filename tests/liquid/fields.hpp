// Fields whose surfaces are known.
#pragma once

#include "liquid/surface/sampled_field.hpp"

namespace pastoso::liquid::test {

template <class Value>
SampledField sampled(const Lattice& lattice, const Value& value) {
    SampledField field(lattice);
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i)
                field.at(i, j, k) = value(lattice.point_m(i, j, k));
    return field;
}

/// n samples across a metre, from half a spacing to one metre less half a spacing.
inline Lattice unit_lattice(int n) {
    const float spacing = 1.0F / static_cast<float>(n);
    return {n, n, n, spacing, glm::vec3(0.5F * spacing)};
}

}  // namespace pastoso::liquid::test
