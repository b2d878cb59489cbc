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

/// The source tiles of a coarse tile.
std::vector<int> tiles_below(const grid::Shape& fine, const grid::Shape& coarse, int tile, int factor) {
    std::vector<int> tiles;
    const int left = tile % coarse.tiles_x() * factor, top = tile / coarse.tiles_x() * factor;
    for (int y = top; y < std::min(fine.tiles_y(), top + factor); ++y)
        for (int x = left; x < std::min(fine.tiles_x(), left + factor); ++x)
            tiles.push_back(y * fine.tiles_x() + x);
    return tiles;
}

/// Fills the tile of the coarse field; `bare` stands for tiles of the fine one that are background.
template <class Field, class Value>
void average(const Field& fine, int factor, const Value& bare, int tile, Field& coarse) {
    const grid::Shape& shape = fine.shape();
    bool any = false;
    const std::vector<int> below = tiles_below(shape, coarse.shape(), tile, factor);
    for (const int source : below)
        any = any || !fine.is_background(source);
    if (!any) return;

    std::vector<typename Channels<Value>::Sums> sums(kTileCells);
    std::vector<int> counts(kTileCells, 0);
    for (const int source : below) {
        const bool is_bare = fine.is_background(source);
        const auto values = fine.read(source);
        const grid::Rect cells = shape.tile_cells(source);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                const int into = grid::Shape::cell_in_tile(x / factor, y / factor);
                Channels<Value>::add(sums[into],
                                     is_bare ? bare : values[grid::Shape::cell_in_tile(x, y)]);
                ++counts[into];
            }
    }
    auto block = grid::TileBlock<Value>::filled(bare);
    for (int cell = 0; cell < kTileCells; ++cell)
        if (counts[cell] > 0) block.write()[cell] = Channels<Value>::mean(sums[cell], counts[cell]);
    coarse.replace(tile, std::move(block));
}

}  // namespace

film::FilmState coarse_film(const film::FilmState& film, int factor, const pigment::Bands& bare_ground,
                            core::ThreadPool& pool) {
    PASTOSO_CHECK(factor >= 1 && factor <= kTileSize && kTileSize % factor == 0);
    const grid::Shape shape{(film.shape.width + factor - 1) / factor,
                            (film.shape.height + factor - 1) / factor};
    film::FilmState coarse(shape, film.cell_mm * factor);
    const film::Strata& strata = film.strata;
    pool.run(static_cast<std::size_t>(shape.tile_count()), [&](std::size_t index, int) {
        const auto tile = static_cast<int>(index);
        average(film.thickness, factor, std::int32_t{0}, tile, coarse.thickness);
        average(film.paint, factor, film::PaintCell{}, tile, coarse.paint);
        average(film.support_mm, factor, 0.0F, tile, coarse.support_mm);
        average(strata.soluble_thickness, factor, std::int32_t{0}, tile,
                coarse.strata.soluble_thickness);
        average(strata.soluble_pigment, factor, film::PigmentCell{}, tile,
                coarse.strata.soluble_pigment);
        average(strata.ground, factor, bare_ground, tile, coarse.strata.ground);
    });
    return coarse;
}

}  // namespace pastoso::project
