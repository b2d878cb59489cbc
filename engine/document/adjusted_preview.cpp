#include "document/adjusted_preview.hpp"

#include "document/layered_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::document {

using film::FilmState;

Snapshot AdjustedPreview::of(const Snapshot& painting, const WantedAdjustment& wanted,
                             const PreviewStep& step, core::ThreadPool& pool) {
    const FilmState& film = painting.active ? *painting.active : painting.film;
    begin(film, {painting.layers, painting.bare, painting.selection, painting.masking, wanted});
    forget_changed(film);
    adjust(film, tiles_to_adjust(step), pool);
    FilmState active = with_adjusted_tiles(film);
    Snapshot seen = painting;
    if (painting.active == nullptr) {
        seen.film = std::move(active);
        return seen;
    }
    seen.film = seen_by(view_, lifter_.lifted_off(active, base_mm_), painting.bare->support_mm,
                        *painting.layers, pool);
    seen.active = std::make_shared<const FilmState>(std::move(active));
    return seen;
}

bool AdjustedPreview::complete() const {
    return std::all_of(tiles_.begin(), tiles_.end(), [](Tile tile) { return tile == Tile::Adjusted; });
}

void AdjustedPreview::begin(const FilmState& film, const Basis& basis) {
    if (basis == basis_) return;
    Basis same_but_wanted = basis;
    same_but_wanted.wanted = basis_.wanted;
    if (same_but_wanted == basis_) {
        std::replace(tiles_.begin(), tiles_.end(), Tile::Adjusted, Tile::AdjustedOtherwise);
    } else {
        base_mm_ = base_below_active(*basis.layers, basis.bare->support_mm);
        where_ = without_masked(basis.selection, basis.masking);
        after_ = FilmState(film.shape, film.cell_mm);
        tiles_.assign(static_cast<std::size_t>(film.shape.tile_count()), Tile::Unadjusted);
        before_ = film;
    }
    basis_ = basis;
}

void AdjustedPreview::forget_changed(const FilmState& film) {
    for (int tile = 0; tile < film.shape.tile_count(); ++tile)
        if (!layers::looks_same(film, before_, tile))
            tiles_[static_cast<std::size_t>(tile)] = Tile::Unadjusted;
    before_ = film;
}

std::vector<int> AdjustedPreview::tiles_to_adjust(const PreviewStep& step) const {
    const grid::Shape& shape = before_.shape;
    const auto distance = [&](int tile) {
        const grid::Rect cells = shape.tile_cells(tile);
        return std::hypot(cells.x0 + cells.x1 - step.around.x0 - step.around.x1,
                          cells.y0 + cells.y1 - step.around.y0 - step.around.y1);
    };
    std::vector<int> tiles;
    for (int tile = 0; tile < shape.tile_count(); ++tile)
        if (tiles_[static_cast<std::size_t>(tile)] != Tile::Adjusted) tiles.push_back(tile);
    std::stable_sort(tiles.begin(), tiles.end(),
                     [&](int a, int b) { return distance(a) < distance(b); });
    if (tiles.size() > static_cast<std::size_t>(step.most_tiles))
        tiles.resize(static_cast<std::size_t>(step.most_tiles));
    return tiles;
}

/// Tiles in which nothing is adjusted stay the film's own, so that they count as unchanged.
void AdjustedPreview::adjust(const FilmState& film, const std::vector<int>& tiles,
                             core::ThreadPool& pool) {
    if (tiles.empty()) return;
    FilmState part(film.shape, film.cell_mm);
    part.support_mm = base_mm_;
    for (const int tile : tiles)
        layers::take_tile(film, tile, part);
    const FilmState layer = layers::lifted_off(part, base_mm_);
    const FilmState after =
        layers::adjusted(layer, basis_.wanted.paint, basis_.wanted.way, where_.get(), pool).film;
    const FilmState laid = layers::laid_on(after, base_mm_);
    for (const int tile : tiles) {
        const bool same = layers::looks_same(layer, after, tile);
        layers::take_seen_tile(same ? film : laid, tile, after_);
        tiles_[static_cast<std::size_t>(tile)] = Tile::Adjusted;
    }
}

FilmState AdjustedPreview::with_adjusted_tiles(const FilmState& film) const {
    FilmState active = film;
    for (int tile = 0; tile < film.shape.tile_count(); ++tile)
        if (tiles_[static_cast<std::size_t>(tile)] != Tile::Unadjusted)
            layers::take_seen_tile(after_, tile, active);
    return active;
}

}  // namespace pastoso::document
