#include "layers/poured_film.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pastoso::layers {
namespace {

using film::FilmState;
using film::PaintCell;
using grid::TileBlock;

struct PouredTile {
    TileBlock<std::int32_t> thickness = TileBlock<std::int32_t>::filled(0);
    TileBlock<PaintCell> paint = TileBlock<PaintCell>::filled({});
};

/// What a film of the first and the second paint carries.
PaintCell carried(const PouredPaint& poured, double second_share, double thickness_mm) {
    PaintCell cell{};
    for (int k = 0; k < film::kPaintChannels; ++k) {
        const double first = poured.paint[k];
        const double second = poured.gradient ? poured.gradient->second[k] : first;
        const double per_mm = first + second_share * (second - first);
        cell[k] = static_cast<std::int32_t>(std::lround(per_mm * thickness_mm / film::kPaintQuantum));
    }
    return cell;
}

/// At the centre of a cell.
double second_share(const Gradient& gradient, int x, int y) {
    const double along_x = gradient.to.x - gradient.from.x, along_y = gradient.to.y - gradient.from.y;
    const double way = (x + 0.5 - gradient.from.x) * along_x + (y + 0.5 - gradient.from.y) * along_y;
    return std::clamp(way / (along_x * along_x + along_y * along_y), 0.0, 1.0);
}

class Pouring {
  public:
    Pouring(const PouredPaint& poured, const grid::Mask* where)
        : poured_(poured),
          where_(where),
          quanta_(
              static_cast<std::int32_t>(std::lround(poured.thickness_mm / film::kThicknessQuantum_mm))),
          even_(carried(poured, 0.0, quanta_ * film::kThicknessQuantum_mm)) {}

    PouredTile tile(const grid::Rect& cells, int tile) const {
        PouredTile poured;
        for (int y = cells.y0; y < cells.y1; ++y) {
            for (int x = cells.x0; x < cells.x1; ++x) {
                const int cell = grid::Shape::cell_in_tile(x, y);
                const std::int32_t whole =
                    poured_.relief == nullptr ? quanta_ : poured_.relief->read(tile)[cell];
                const std::int32_t quanta =
                    where_ == nullptr ? whole : grid::share_of(whole, where_->read(tile)[cell]);
                if (quanta == 0) continue;
                poured.thickness.write()[cell] = quanta;
                poured.paint.write()[cell] = at(x, y, quanta);
            }
        }
        return poured;
    }

  private:
    PaintCell at(int x, int y, std::int32_t quanta) const {
        if (!poured_.gradient && quanta == quanta_) return even_;
        const double share = poured_.gradient ? second_share(*poured_.gradient, x, y) : 0.0;
        return carried(poured_, share, quanta * film::kThicknessQuantum_mm);
    }

    const PouredPaint& poured_;
    const grid::Mask* where_;
    std::int32_t quanta_;
    PaintCell even_;
};

}  // namespace

FilmState poured_film(const PouredPaint& poured, grid::Shape shape, double cell_mm,
                      const grid::Mask* where, core::ThreadPool& pool) {
    FilmState film(shape, cell_mm);
    film::add_medium(film, film::film_numbers_of(poured.medium));
    film.consistencies.add(film::consistency_of(poured.paint));
    if (poured.gradient) film.consistencies.add(film::consistency_of(poured.gradient->second));
    std::vector<int> tiles;
    for (int tile = 0; tile < shape.tile_count(); ++tile)
        if (where == nullptr || !grid::chooses_none(*where, tile)) tiles.push_back(tile);
    const Pouring pouring(poured, where);
    std::vector<PouredTile> made(tiles.size());
    pool.run(tiles.size(), [&](std::size_t index, int) {
        made[index] = pouring.tile(shape.tile_cells(tiles[index]), tiles[index]);
    });
    for (std::size_t index = 0; index < tiles.size(); ++index) {
        film.thickness.replace(tiles[index], std::move(made[index].thickness));
        film.paint.replace(tiles[index], std::move(made[index].paint));
    }
    return film;
}

}  // namespace pastoso::layers
