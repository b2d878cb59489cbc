#include "project/coarse_film.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace pastoso::project {
namespace {

using grid::kTileCells;
using grid::kTileSize;

/// Sums of a value's channels, and a value of their means.
template <class Value>
struct Channels;
template <class Number, std::size_t kCount>
struct Channels<std::array<Number, kCount>> {
    using Sums = std::array<double, kCount>;
    static void add(Sums& sums, const std::array<Number, kCount>& value) {
        for (std::size_t k = 0; k < kCount; ++k)
            sums[k] += static_cast<double>(value[k]);
    }
    static std::array<Number, kCount> mean(const Sums& sums, double count) {
        std::array<Number, kCount> value;
        for (std::size_t k = 0; k < kCount; ++k)
            value[k] = static_cast<Number>(sums[k] / count);
        return value;
    }
};
template <class Number>
requires std::is_arithmetic_v<Number>
struct Channels<Number> {
    using Sums = double;
    static void add(Sums& sum, Number value) { sum += static_cast<double>(value); }
    static Number mean(const Sums& sum, double count) { return static_cast<Number>(sum / count); }
};

template <class Field>
using ValueOf = std::remove_cvref_t<decltype(std::declval<const Field&>().read(0)[0])>;

/// The source tiles of a coarse tile.
std::vector<int> tiles_below(const grid::Shape& fine, const grid::Shape& coarse, int tile, int factor) {
    std::vector<int> tiles;
    const int left = tile % coarse.tiles_x() * factor, top = tile / coarse.tiles_x() * factor;
    for (int y = top; y < std::min(fine.tiles_y(), top + factor); ++y)
        for (int x = left; x < std::min(fine.tiles_x(), left + factor); ++x)
            tiles.push_back(y * fine.tiles_x() + x);
    return tiles;
}

/// Fills the tile of the coarse field.
template <class Field>
void average(const Field& fine, int factor, int tile, Field& coarse) {
    using Value = ValueOf<Field>;
    const grid::Shape& shape = fine.shape();
    bool any = false;
    const std::vector<int> below = tiles_below(shape, coarse.shape(), tile, factor);
    for (const int source : below)
        any = any || !fine.is_background(source);
    if (!any) return;

    std::vector<typename Channels<Value>::Sums> sums(kTileCells);
    std::vector<int> counts(kTileCells, 0);
    for (const int source : below) {
        const auto values = fine.read(source);
        const grid::Rect cells = shape.tile_cells(source);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                const int into = grid::Shape::cell_in_tile(x / factor, y / factor);
                Channels<Value>::add(sums[into], values[grid::Shape::cell_in_tile(x, y)]);
                ++counts[into];
            }
    }
    auto block = grid::TileBlock<Value>::filled(coarse.read(tile)[0]);
    for (int cell = 0; cell < kTileCells; ++cell)
        if (counts[cell] > 0) block.write()[cell] = Channels<Value>::mean(sums[cell], counts[cell]);
    coarse.replace(tile, std::move(block));
}

}  // namespace

film::FilmState coarse_film(const film::FilmState& film, int factor, core::ThreadPool& pool) {
    PASTOSO_CHECK(factor >= 1 && factor <= kTileSize && kTileSize % factor == 0);
    const grid::Shape shape{(film.shape.width + factor - 1) / factor,
                            (film.shape.height + factor - 1) / factor};
    film::FilmState coarse(shape, film.cell_mm * factor);
    const film::Strata& strata = film.strata;
    pool.run(static_cast<std::size_t>(shape.tile_count()), [&](std::size_t index, int) {
        const auto tile = static_cast<int>(index);
        average(film.thickness, factor, tile, coarse.thickness);
        average(film.paint, factor, tile, coarse.paint);
        average(film.lower.thickness, factor, tile, coarse.lower.thickness);
        average(film.lower.paint, factor, tile, coarse.lower.paint);
        average(film.support_mm, factor, tile, coarse.support_mm);
        average(strata.soluble_thickness, factor, tile, coarse.strata.soluble_thickness);
        average(strata.soluble_pigment, factor, tile, coarse.strata.soluble_pigment);
        average(strata.optics, factor, tile, coarse.strata.optics);
    });
    return coarse;
}

}  // namespace pastoso::project
