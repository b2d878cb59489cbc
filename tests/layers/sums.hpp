// Everything that is counted of a layer.
#pragma once

#include "film/state.hpp"
#include "film/support/support.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace pastoso::layers::test {

struct Sums {
    std::int64_t thickness = 0;  ///< wet, dry and evaporated
    std::array<std::int64_t, film::kPigmentChannels> pigment{};
    std::int64_t relief = 0;  ///< of the dry surface, steps of the support
    friend bool operator==(const Sums&, const Sums&) = default;
};

inline Sums sums_of(const film::FilmState& layer) {
    const film::Totals wet = film::totals(layer);
    const film::DriedTotals dried = film::dried_totals(layer.strata);
    Sums sums{wet.thickness + dried.thickness + layer.strata.evaporated, {}, 0};
    for (int k = 0; k < film::kPigmentChannels; ++k)
        sums.pigment[k] = wet.paint[k] + dried.pigment[k];
    for (int y = 0; y < layer.shape.height; ++y)
        for (int x = 0; x < layer.shape.width; ++x)
            sums.relief += std::llround(layer.support_mm.at(x, y) / film::kSupportQuantum_mm);
    return sums;
}

inline Sums operator+(Sums a, const Sums& b) {
    a.thickness += b.thickness;
    for (int k = 0; k < film::kPigmentChannels; ++k)
        a.pigment[k] += b.pigment[k];
    a.relief += b.relief;
    return a;
}

}  // namespace pastoso::layers::test
