// Films of known media that the tests let dry.
#pragma once

#include "film/medium.hpp"
#include "film/state.hpp"
#include "film/strewn_strata.hpp"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace pastoso::film::test {

inline constexpr pigment::Bands kWhiteGround = {0.90F, 0.93F, 0.93F, 0.93F, 0.93F, 0.93F};

/// Shares of light are kept in 65535ths, which rounds each of a stratum's three by half of one.
inline constexpr float kCodeRounding = 3e-5F;

/// Reflectances of pigment over a ground, without a detour over what a layer does by itself.
inline pigment::Bands wet_over(const std::int32_t* pigment, const pigment::Bands& ground) {
    pigment::Bands reflectance{};
    for (int band = 0; band < pigment::kBands; ++band)
        reflectance[band] =
            pigment::layer_reflectance(optical_thickness(pigment[band]),
                                       optical_thickness(pigment[band + pigment::kBands]), ground[band]);
    return reflectance;
}

inline void expect_seen(const StrataOptics& strata, const pigment::Bands& seen) {
    for (int band = 0; band < pigment::kBands; ++band)
        EXPECT_NEAR(pigment::reflectance_over(optics_of(strata, band), kWhiteGround[band]), seen[band],
                    kCodeRounding)
            << "band " << band;
}
inline constexpr pigment::Coefficients kBlue = {1, 11, 41, 91, 108, 84, 1, 1, 1, 3, 3, 3};
inline constexpr pigment::Coefficients kRed = {119, 164, 184, 218, 23, 0.4F, 8, 11, 13, 22, 63, 56};

inline std::int32_t quanta_of(double mm) {
    return static_cast<std::int32_t>(std::lround(mm / kThicknessQuantum_mm));
}

/// What a cell of fresh paint of this thickness carries.
inline PaintCell cell_of(const PaintCoefficients& paint, double thickness_mm) {
    PaintCell cell{};
    for (int k = 0; k < kPaintChannels; ++k)
        cell[k] = static_cast<std::int32_t>(std::lround(paint[k] * thickness_mm / kPaintQuantum));
    return cell;
}

inline void lay(FilmState& film, int x, int y, double thickness_mm, const pigment::Coefficients& pigment,
                const Medium& medium) {
    film.thickness.set(x, y, quanta_of(thickness_mm));
    film.paint.set(x, y, cell_of(paint_coefficients(pigment, medium), thickness_mm));
}

inline void lay(FilmState& film, const std::function<double(int, int)>& thickness_mm,
                const pigment::Coefficients& pigment, const Medium& medium) {
    for (int y = 0; y < film.shape.height; ++y)
        for (int x = 0; x < film.shape.width; ++x)
            lay(film, x, y, thickness_mm(x, y), pigment, medium);
}

/// Patches of all media, some of them dry before.
inline FilmState patchwork(std::uint32_t seed) {
    FilmState film({150, 90}, 0.25);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            if (share(random) < 0.3) continue;
            const auto& media = bundled_media();
            const Medium& medium = media[static_cast<std::size_t>(x / 26) % media.size()];
            lay(film, x, y, 2.0 * medium.typical_thickness_mm * share(random),
                share(random) < 0.5 ? kBlue : kRed, medium);
        }
    }
    strew_strata(film, seed);
    return film;
}

}  // namespace pastoso::film::test
