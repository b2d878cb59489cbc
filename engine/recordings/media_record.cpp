#include "recordings/media_record.hpp"

#include "recordings/paint_json.hpp"

#include <algorithm>

namespace pastoso::recordings {
namespace {

using files::Json;
using files::JsonPlace;
using film::FilmNumbers;

Json numbers_json(const FilmNumbers& numbers) {
    const film::Medium medium = film::with_film_numbers({}, numbers);
    Json json = Json::object();
    for (const film::FilmNumber& number : film::film_number_list())
        for (const film::MediumNumber& named : film::medium_numbers())
            if (named.member == number.of_medium) json[named.key] = medium.*named.member;
    return json;
}

std::vector<FilmNumbers> read_list(const JsonPlace& place) {
    if (place.size() > film::kMostMedia) place.fail("expected %1 media at most.", film::kMostMedia);
    std::vector<FilmNumbers> numbers;
    for (std::size_t k = 0; k < place.size(); ++k)
        numbers.push_back(film::film_numbers_of(read_medium_numbers(place.element(k), film::Medium{})));
    return numbers;
}

bool is_possible(const film::MediaCell& cell, std::size_t media, std::int32_t thickness) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        if (cell[k] < 0 || (k >= media && cell[k] != 0)) return false;
        sum += cell[k];
    }
    return sum <= thickness;
}

}  // namespace

MediaIndex media_index(const film::WetMedia& media) {
    return {media.numbers, media.are_several() ? media.own : std::vector<std::uint8_t>{}};
}

void set_media(const MediaIndex& index, film::FilmState& film) {
    film.media.numbers = index.numbers;
    if (!index.own.empty()) film.media.own = index.own;
}

Json media_json(const MediaIndex& index) {
    Json numbers = Json::array();
    for (const FilmNumbers& medium : index.numbers)
        numbers.push_back(numbers_json(medium));
    Json json{{"numbers", std::move(numbers)}};
    if (!index.own.empty()) json["of_tiles"] = index.own;
    return json;
}

MediaIndex read_media(const JsonPlace& place, int tile_count) {
    place.allow_only({"numbers", "of_tiles"});
    MediaIndex index{read_list(place.entry("numbers")), {}};
    const auto own = place.optional_entry("of_tiles");
    if (!own) return index;
    if (own->size() != static_cast<std::size_t>(tile_count))
        own->fail("expected %1 numbers, one for each tile.", tile_count);
    const auto last = static_cast<std::int64_t>(index.numbers.size()) - 1;
    for (std::size_t tile = 0; tile < own->size(); ++tile)
        index.own.push_back(static_cast<std::uint8_t>(own->element(tile).integer(0, last)));
    return index;
}

Json held_media_json(const brush::HeldMedia& media) {
    Json numbers = Json::array();
    for (const FilmNumbers& medium : media.numbers)
        numbers.push_back(numbers_json(medium));
    return {{"numbers", std::move(numbers)}, {"volume_mm3", media.volume_mm3}};
}

brush::HeldMedia read_held_media(const JsonPlace& place) {
    place.allow_only({"numbers", "volume_mm3"});
    brush::HeldMedia media{read_list(place.entry("numbers")), {}};
    const JsonPlace volumes = place.entry("volume_mm3");
    if (volumes.size() != media.numbers.size()) volumes.fail("expected one number for each medium.");
    for (std::size_t k = 0; k < volumes.size(); ++k) {
        constexpr double kMost_mm3 = 1e7;
        const double volume_mm3 = volumes.element(k).number();
        if (!(volume_mm3 >= 0.0 && volume_mm3 <= kMost_mm3))
            volumes.element(k).fail("expected 0 to 10000000.");
        media.volume_mm3.push_back(volume_mm3);
    }
    return media;
}

bool are_possible(const film::WetMedia& media, const grid::TiledField<std::int32_t>& thickness) {
    for (int tile = 0; tile < media.foreign.tile_count(); ++tile) {
        if (!media.is_mixed(tile)) continue;
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            if (!is_possible(media.foreign.read(tile)[cell], media.numbers.size(),
                             thickness.read(tile)[cell]))
                return false;
    }
    return true;
}

}  // namespace pastoso::recordings
