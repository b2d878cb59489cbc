#include "film/cell/film_numbers.hpp"

#include "film/medium.hpp"

#include <array>

namespace pastoso::film {

std::span<const FilmNumber> film_number_list() {
    static constexpr std::array kNumbers = {
        FilmNumber{&FilmNumbers::density_kg_m3, &Medium::density_kg_m3},
        FilmNumber{&FilmNumbers::flow_index, &Medium::flow_index},
        FilmNumber{&FilmNumbers::structure_share, &Medium::structure_share},
        FilmNumber{&FilmNumbers::recovery_s, &Medium::recovery_s},
        FilmNumber{&FilmNumbers::breakdown_strain, &Medium::breakdown_strain},
        FilmNumber{&FilmNumbers::surface_tension_N_m, &Medium::surface_tension_N_m},
        FilmNumber{&FilmNumbers::advancing_angle_deg, &Medium::advancing_angle_deg},
        FilmNumber{&FilmNumbers::receding_angle_deg, &Medium::receding_angle_deg},
        FilmNumber{&FilmNumbers::slip_cells, &Medium::slip_cells},
        FilmNumber{&FilmNumbers::alpha_min, &Medium::alpha_min},
        FilmNumber{&FilmNumbers::alpha_max, &Medium::alpha_max},
    };
    return kNumbers;
}

FilmNumbers film_numbers_of(const Medium& medium) {
    FilmNumbers numbers;
    for (const FilmNumber& number : film_number_list())
        numbers.*number.of_film = medium.*number.of_medium;
    return numbers;
}

Medium with_film_numbers(const Medium& medium, const FilmNumbers& numbers) {
    Medium result = medium;
    for (const FilmNumber& number : film_number_list())
        result.*number.of_medium = numbers.*number.of_film;
    return result;
}

}  // namespace pastoso::film
