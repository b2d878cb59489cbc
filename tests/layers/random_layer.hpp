// Layers with paint of every kind: bare, wet, dry, dissolvable, and several of them in one cell.
#pragma once

#include "core/random.hpp"
#include "core/thread_pool.hpp"
#include "film/cell/cell_drying.hpp"
#include "film/cell/drying.hpp"
#include "film/dry_film.hpp"

namespace pastoso::layers::test {

inline constexpr grid::Shape kShape{150, 70};
inline constexpr double kCell_mm = 0.25;

inline film::FilmState bare_layer() {
    return film::FilmState(kShape, kCell_mm);
}

/// One bit of chance for a cell: the same for the same numbers.
inline bool chance(int x, int y, std::uint32_t seed, float share) {
    return core::uniform_noise(static_cast<std::uint32_t>(y * kShape.width + x), seed) < share;
}

/// Lays wet paint into about that share of the cells of the canvas's left part, and dries it.
inline void paint(film::FilmState& film, const char* medium, const pigment::Coefficients& pigment,
                  float share, std::uint32_t seed) {
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < 120; ++x)
            if (chance(x, y, seed, share))
                film::test::lay(film, x, y, 0.02 + 0.3 * core::uniform_noise(x + 1000 * y, seed + 1),
                                pigment, film::find_medium(medium));
}

/// About half of the wet paint is worked, here more, there less.
inline void work_here_and_there(film::FilmState& film, std::uint32_t seed) {
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            if (film.thickness.at(x, y) > 0 && chance(x, y, seed, 0.5F))
                film.worked.thickness.set(x, y, film.thickness.at(x, y) / (1 + x % 3));
}

/// Makes some of the wet paint paint of two other media.
inline void mix_media(film::FilmState& film, std::uint32_t seed) {
    film.media.numbers = {film::film_numbers_of(film::find_medium("heavy-body oil"))};
    film::Medium other = film::find_medium("thinner");
    for (int k = 0; k < 2; ++k) {
        other.surface_tension_N_m += 0.001 * seed;
        const int place = film::add_medium(film, film::film_numbers_of(other));
        for (int y = 0; y < kShape.height; ++y)
            for (int x = 0; x < kShape.width; ++x)
                if (film.thickness.at(x, y) > 0 && chance(x, y, seed + 20 * k, 0.4F)) {
                    film::MediaCell cell = film.media.foreign.at(x, y);
                    cell[place] = film.thickness.at(x, y) / (2 + x % 3);
                    film.media.foreign.set(x, y, cell);
                }
    }
}

/// Strata, then a dissolvable one, then wet paint, each in a part of the cells; the right tile is bare.
inline film::FilmState random_layer(std::uint32_t seed) {
    core::ThreadPool pool(1);
    film::FilmState layer = bare_layer();
    paint(layer, "soft-body acrylic", film::test::kBlue, 0.3F, 10 * seed);
    film::dry_now(layer, pool);
    paint(layer, "ink glaze", film::test::kRed, 0.3F, 10 * seed + 3);
    film::dry_now(layer, pool);
    paint(layer, "heavy-body oil", film::test::kBlue, 0.4F, 10 * seed + 6);
    film::test::strew_strata(layer, seed);
    work_here_and_there(layer, 10 * seed + 9);
    mix_media(layer, seed);
    return layer;
}

}  // namespace pastoso::layers::test
