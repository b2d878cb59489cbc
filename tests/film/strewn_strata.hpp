// Two wet strata here and there, of any thickness and colour, for whatever has to bring them along.
#pragma once

#include "core/random.hpp"
#include "film/state.hpp"

namespace pastoso::film::test {

/// In about half of the wet cells, a part of the paint comes to lie below: another share of the thickness
/// and of each channel.
inline void strew_strata(FilmState& film, std::uint32_t seed) {
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x) {
            const auto cell = static_cast<std::uint32_t>(y * film.shape.width + x);
            const auto share = [&](std::uint32_t stream) {
                return core::uniform_noise(cell, 100 * seed + stream);
            };
            const std::int32_t thickness = film.thickness.at(x, y);
            if (thickness < 4 * kLeastStratum_quanta || share(0) < 0.5F) continue;
            PaintCell below{};
            for (int k = 0; k < kPaintChannels; ++k)
                below[k] = static_cast<std::int32_t>(share(2 + static_cast<std::uint32_t>(k)) *
                                                     0.9F * static_cast<float>(film.paint.at(x, y)[k]));
            film.lower.thickness.set(
                x, y, static_cast<std::int32_t>((0.25F + 0.5F * share(1)) * static_cast<float>(thickness)));
            film.lower.paint.set(x, y, below);
        }
}

}  // namespace pastoso::film::test
