#include "brush/media_exchange.hpp"

#include "brush/brush.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pastoso::brush {
namespace {

using film::kMostMedia;
using film::MediaCell;

void give_what_is_held(const HeldMedia& held, MediaExchange& media) {
    std::array<double, kMostMedia> amounts{};
    std::copy(held.volume_mm3.begin(), held.volume_mm3.end(), amounts.begin());
    media.give_shares_of(amounts);
}

/// What a cell gained and lost in an exchange, quanta.
struct CellExchange {
    std::int32_t before, after, gained;
    float kept;  ///< share of what was there
};
CellExchange cell_exchange(const ApplyRule& rule, const TileCells& cells, int i) {
    const std::int32_t before = cells.held[i], after = cells.thickness[cells.cell[i]];
    const auto wanted = static_cast<std::int32_t>(static_cast<float>(cells.swap[i]) * rule.swap_scale);
    const std::int32_t swapped = std::clamp(wanted, 0, std::min(before, after));
    const std::int32_t lost = swapped + std::max(before - after, 0);
    const float whole = static_cast<float>(std::max(before, 1));
    return {before, after, swapped + std::max(after - before, 0),
            1.0F - static_cast<float>(lost) / whole};
}

/// Changes the foreign media of a cell; what is not of those is of the tile's own.
void exchange_cell(const CellExchange& change, int own, MediaCell& foreign, MediaExchange& media) {
    std::int32_t left = change.after, own_gained = change.after - change.before;
    for (int k = 0; k < kMostMedia; ++k) {
        if (k == own || (foreign[k] == 0 && media.given[k] == 0.0F)) continue;
        const float wanted = static_cast<float>(foreign[k]) * change.kept +
                             static_cast<float>(change.gained) * media.given[k];
        const auto amount = std::clamp(static_cast<std::int32_t>(std::lround(wanted)), 0, left);
        left -= amount;
        media.gained[k] += amount - foreign[k];
        own_gained -= amount - foreign[k];
        foreign[k] = amount;
    }
    media.gained[own] += own_gained;
}

}  // namespace

void MediaExchange::give_shares_of(const std::array<double, kMostMedia>& amounts) {
    const double whole = std::accumulate(amounts.begin(), amounts.end(), 0.0);
    for (std::size_t k = 0; k < amounts.size(); ++k)
        given[k] = whole > 0.0 ? static_cast<float>(amounts[k] / whole) : 0.0F;
}

int MediaExchange::main() const {
    return static_cast<int>(std::max_element(given.begin(), given.end()) - given.begin());
}

std::optional<MediaExchange> meet_media(Brush& brush, film::FilmState& film) {
    const HeldMedia held = std::move(brush.media);
    std::vector<std::pair<int, double>> places;
    for (std::size_t k = 0; k < held.numbers.size(); ++k)
        if (held.volume_mm3[k] > 0.0)
            places.emplace_back(film::add_medium(film, held.numbers[k]), held.volume_mm3[k]);
    brush.media = {film.media.numbers, std::vector<double>(film.media.numbers.size(), 0.0)};
    for (const auto& [place, volume_mm3] : places)
        brush.media.volume_mm3[place] += volume_mm3;
    if (!film.media.are_several()) return std::nullopt;
    MediaExchange media;
    give_what_is_held(brush.media, media);
    return media;
}

void settle_exchange(MediaExchange& media, const film::FilmState& film, Brush& brush) {
    const double quantum_mm3 = film::kThicknessQuantum_mm * film.cell_mm * film.cell_mm;
    for (std::size_t k = 0; k < brush.media.volume_mm3.size(); ++k) {
        double& volume_mm3 = brush.media.volume_mm3[k];
        volume_mm3 = std::max(0.0, volume_mm3 - static_cast<double>(media.gained[k]) * quantum_mm3);
    }
    media.gained = {};
    give_what_is_held(brush.media, media);
}

void weigh_media(const film::FilmState& film, Brush& brush) {
    std::vector<double>& volumes = brush.media.volume_mm3;
    const double held_mm3 = std::max(0.0, brush.contents().volume_mm3);
    const double told_mm3 = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    if (film.media.numbers.size() == 1)
        volumes = {held_mm3};
    else if (told_mm3 > 0.0)
        for (double& volume_mm3 : volumes)
            volume_mm3 *= held_mm3 / told_mm3;
}

void prepare_media(const MediaExchange& media, const grid::Rect& cells, film::FilmState& film) {
    const grid::Rect tiles = film.shape.tiles_touching(cells);
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x) {
            const int tile = y * film.shape.tiles_x() + x;
            std::uint8_t& own = film.media.own[tile];
            if (film.thickness.is_background(tile)) own = static_cast<std::uint8_t>(media.main());
            if (film.media.is_mixed(tile) || !media.gives_only(own)) film.media.foreign.write(tile);
        }
}

void exchange_media(const ApplyRule& rule, const TileCells& cells, int tile, film::FilmState& film,
                    MediaExchange& media) {
    const int own = film.media.own[tile];
    MediaCell* foreign = film.media.is_mixed(tile) ? film.media.foreign.write(tile) : nullptr;
    for (int i = 0; i < cells.count; ++i) {
        const CellExchange change = cell_exchange(rule, cells, i);
        if (foreign == nullptr)
            media.gained[own] += change.after - change.before;
        else if (change.before != change.after || cells.swap[i] != 0)
            exchange_cell(change, own, foreign[cells.cell[i]], media);
    }
}

}  // namespace pastoso::brush
