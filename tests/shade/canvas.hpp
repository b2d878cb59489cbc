// Canvases made by hand: support and paint as functions of the cell.
#pragma once

#include "film/state.hpp"
#include "pigment/bands.hpp"

#include <cmath>
#include <random>

namespace pastoso::test {

inline constexpr pigment::Bands kGround = {0.90F, 0.93F, 0.93F, 0.93F, 0.93F, 0.93F};

/// Coefficients of a strong blue and a strong red, per mm.
inline constexpr pigment::Coefficients kBlue = {1, 11, 41, 91, 108, 84, 1, 1, 1, 3, 3, 3};
inline constexpr pigment::Coefficients kRed = {119, 164, 184, 218, 23, 0.4F, 8, 11, 13, 22, 63, 56};

/// height(x, y) in mm.
template <class Height>
void set_support(film::FilmState& film, const Height& height) {
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            film.support_mm.set(x, y, static_cast<float>(height(x, y)));
        }
    }
}

inline void set_paint(film::FilmState& film, int x, int y, double thickness_mm,
                      const pigment::Coefficients& paint) {
    film.thickness.set(
        x, y, static_cast<std::int32_t>(std::lround(thickness_mm / film::kThicknessQuantum_mm)));
    film::PaintCell cell{};
    for (int k = 0; k < pigment::kChannels; ++k) {
        cell[k] = static_cast<std::int32_t>(std::lround(paint[k] * thickness_mm / film::kPaintQuantum));
    }
    film.paint.set(x, y, cell);
}

/// Uneven support and blue, red and bare cells in random places.
inline film::FilmState random_canvas(grid::Shape shape, std::uint32_t seed) {
    film::FilmState film(shape, 0.25);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    set_support(film, [&](int, int) { return 0.1 * share(random); });
    for (int y = 0; y < shape.height; ++y) {
        for (int x = 0; x < shape.width; ++x) {
            const double which = share(random);
            if (which < 0.6) set_paint(film, x, y, 0.6 * share(random), which < 0.3 ? kBlue : kRed);
        }
    }
    return film;
}

/// The same canvas seen in a mirror: left and right exchanged.
inline film::FilmState mirrored(const film::FilmState& film) {
    film::FilmState result(film.shape, film.cell_mm);
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            const int from = film.shape.width - 1 - x;
            result.support_mm.set(x, y, film.support_mm.at(from, y));
            result.thickness.set(x, y, film.thickness.at(from, y));
            result.paint.set(x, y, film.paint.at(from, y));
        }
    }
    return result;
}

}  // namespace pastoso::test
