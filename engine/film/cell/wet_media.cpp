#include "film/cell/wet_media.hpp"

#include "film/cell/tile_quanta.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numeric>
#include <utility>

namespace pastoso::film {
namespace {

using grid::kTileCells;
using Media = std::bitset<kMostMedia>;

bool holds_any(const MediaCell& cell) {
    return std::any_of(cell.begin(), cell.end(), [](std::int32_t amount) { return amount != 0; });
}

Media foreign_media(const MediaCell* cells) {
    Media media;
    for (int cell = 0; cell < kTileCells; ++cell)
        for (int k = 0; k < kMostMedia; ++k)
            if (cells[cell][k] != 0) media.set(k);
    return media;
}

Media used_media(const FilmState& state) {
    Media used;
    for (int tile = 0; tile < state.shape.tile_count(); ++tile) {
        if (state.thickness.is_background(tile)) continue;
        used.set(state.media.own[tile]);
        if (state.media.is_mixed(tile)) used |= foreign_media(state.media.foreign.read(tile));
    }
    return used;
}

/// How far apart two media are: the squares of what their numbers differ by, of the larger one.
double difference(const FilmNumbers& a, const FilmNumbers& b) {
    double sum = 0.0;
    for (const FilmNumber& number : film_number_list()) {
        const double of_a = a.*number.of_film, of_b = b.*number.of_film;
        const double part = (of_a - of_b) / std::max({std::abs(of_a), std::abs(of_b), 1e-12});
        sum += part * part;
    }
    return sum;
}

/// Makes paint of the medium `gone` paint of `kept`.
void join(WetMedia& media, int kept, int gone) {
    for (int tile = 0; tile < media.foreign.tile_count(); ++tile) {
        const bool was_own = media.own[tile] == gone;
        if (was_own) media.own[tile] = static_cast<std::uint8_t>(kept);
        if (!media.is_mixed(tile)) continue;
        auto cells = grid::TileBlock<MediaCell>::copy_of(media.foreign.read(tile));
        for (int cell = 0; cell < kTileCells; ++cell) {
            MediaCell& amounts = cells.write()[cell];
            amounts[kept] = media.own[tile] == kept ? 0 : amounts[kept] + amounts[gone];
            amounts[gone] = 0;
        }
        media.replace(tile, std::move(cells));
    }
}

/// Joins the two media that are most alike. Returns the place that is free then.
int join_most_alike(WetMedia& media) {
    int kept = 0, gone = 1;
    double least = difference(media.numbers[0], media.numbers[1]);
    for (int a = 0; a < kMostMedia; ++a)
        for (int b = a + 1; b < kMostMedia; ++b)
            if (const double apart = difference(media.numbers[a], media.numbers[b]); apart < least) {
                least = apart;
                kept = a;
                gone = b;
            }
    join(media, kept, gone);
    return gone;
}

int free_place(FilmState& state) {
    WetMedia& media = state.media;
    if (media.numbers.size() < kMostMedia) {
        media.numbers.emplace_back();
        return static_cast<int>(media.numbers.size()) - 1;
    }
    const Media used = used_media(state);
    for (int k = 0; k < kMostMedia; ++k)
        if (!used[k]) return k;
    return join_most_alike(media);
}

}  // namespace

void WetMedia::become_one(const FilmNumbers& medium) {
    numbers = {medium};
    std::fill(own.begin(), own.end(), std::uint8_t{0});
    for (int tile = 0; tile < foreign.tile_count(); ++tile)
        foreign.reset(tile);
}

void WetMedia::replace(int tile, grid::TileBlock<MediaCell> cells) {
    if (std::any_of(cells.read(), cells.read() + kTileCells, holds_any))
        foreign.replace(tile, std::move(cells));
    else
        foreign.reset(tile);
}

int add_medium(FilmState& state, const FilmNumbers& medium) {
    std::vector<FilmNumbers>& numbers = state.media.numbers;
    const auto found = std::find(numbers.begin(), numbers.end(), medium);
    if (found != numbers.end()) return static_cast<int>(found - numbers.begin());
    const int place = free_place(state);
    numbers[place] = medium;
    return place;
}

double mixed_number(const FilmState& state, int tile, int cell, double FilmNumbers::*number) {
    const WetMedia& media = state.media;
    const std::int32_t thickness = state.thickness.read(tile)[cell];
    if (thickness <= 0) return media.numbers[media.own[tile]].*number;
    const MediaCell amounts = media_in(state, tile, cell);
    double sum = 0.0;
    for (std::size_t k = 0; k < media.numbers.size(); ++k)
        sum += amounts[k] * (media.numbers[k].*number);
    return sum / thickness;
}

MediaCell all_media(const MediaCell& foreign, int own, std::int32_t thickness) {
    MediaCell amounts = foreign;
    const std::int32_t told = std::accumulate(foreign.begin(), foreign.end(), 0);
    amounts[own] = std::max(thickness - told, 0);
    return amounts;
}

MediaCell media_in(const FilmState& state, int tile, int cell) {
    return all_media(state.media.foreign.read(tile)[cell], state.media.own[tile],
                     state.thickness.read(tile)[cell]);
}

void set_media(FilmState& state, int tile, grid::TileBlock<MediaCell> amounts) {
    std::array<std::int64_t, kMostMedia> sums{};
    for (int cell = 0; cell < kTileCells; ++cell)
        for (int k = 0; k < kMostMedia; ++k)
            sums[k] += amounts.read()[cell][k];
    const auto own = std::max_element(sums.begin(), sums.end()) - sums.begin();
    for (int cell = 0; cell < kTileCells; ++cell)
        amounts.write()[cell][own] = 0;
    state.media.own[tile] = static_cast<std::uint8_t>(own);
    state.media.replace(tile, std::move(amounts));
}

void keep_media_shares(FilmState& state, int tile, const std::int32_t* before) {
    if (!state.media.is_mixed(tile)) return;
    const std::int32_t* after = state.thickness.read(tile);
    auto cells = grid::TileBlock<MediaCell>::copy_of(state.media.foreign.read(tile));
    for (int cell = 0; cell < kTileCells; ++cell) {
        if (after[cell] == before[cell]) continue;
        const double grown = before[cell] > 0 ? static_cast<double>(after[cell]) / before[cell] : 0.0;
        for (std::int32_t& amount : cells.write()[cell])
            amount = static_cast<std::int32_t>(amount * grown);
    }
    state.media.replace(tile, std::move(cells));
}

void take_media(const FilmState& from, int tile, FilmState& to) {
    if (to.media.numbers.empty()) to.media.numbers = from.media.numbers;
    if (to.media.numbers == from.media.numbers) {
        to.media.own[tile] = from.media.own[tile];
        to.media.foreign.replace(tile, from.media.foreign.block(tile));
        if (!from.media.is_mixed(tile)) to.media.foreign.reset(tile);
        return;
    }
    const std::vector<int> places = places_of_media(from, to);
    if (places.empty()) return;
    auto amounts = grid::TileBlock<MediaCell>::filled({});
    for (int cell = 0; cell < kTileCells; ++cell)
        amounts.write()[cell] = at_places(media_in(from, tile, cell), places);
    set_media(to, tile, std::move(amounts));
}

std::vector<int> places_of_media(const FilmState& from, FilmState& to) {
    std::vector<int> places;
    for (const FilmNumbers& numbers : from.media.numbers)
        places.push_back(add_medium(to, numbers));
    return places;
}

MediaCell at_places(const MediaCell& amounts, const std::vector<int>& places) {
    MediaCell result{};
    for (std::size_t k = 0; k < places.size(); ++k)
        result[places[k]] += amounts[k];
    return result;
}

void settle_media(FilmState& state, int tile) {
    WetMedia& media = state.media;
    if (!media.is_mixed(tile)) return;
    const std::int32_t* thickness = state.thickness.read(tile);
    auto cells = grid::TileBlock<MediaCell>::copy_of(media.foreign.read(tile));
    std::array<bool, kMostMedia> is_all{};
    is_all.fill(true);
    for (int cell = 0; cell < kTileCells; ++cell) {
        const std::int32_t trace = thickness[cell] >> kTraceBits;
        for (int k = 0; k < kMostMedia; ++k) {
            std::int32_t& amount = cells.write()[cell][k];
            if (amount <= trace) amount = 0;
            is_all[k] = is_all[k] && amount >= thickness[cell] - trace;
        }
    }
    const auto all = std::find(is_all.begin(), is_all.end(), true);
    if (all == is_all.end()) return media.replace(tile, std::move(cells));
    media.own[tile] = static_cast<std::uint8_t>(all - is_all.begin());
    media.foreign.reset(tile);
}

}  // namespace pastoso::film
