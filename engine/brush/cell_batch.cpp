#include "brush/cell_batch.hpp"

#include <algorithm>

namespace pastoso::brush {

namespace {

/// A height no tool reaches, for the padding.
constexpr float kUnreachable_mm = -1e6F;

int whole_below(double x) {
    const int truncated = static_cast<int>(x);
    return truncated - (truncated > x ? 1 : 0);
}

/// A rectangle around the cells whose centres lie within the disc.
grid::Rect cells_within(const Disc& disc) {
    const auto whole = [](double x) {
        constexpr double kFarthest = 1e6;
        return whole_below(std::clamp(x, -kFarthest, kFarthest));
    };
    return {-whole(disc.radius - disc.x), -whole(disc.radius - disc.y), whole(disc.x + disc.radius) + 1,
            whole(disc.y + disc.radius) + 1};
}

}  // namespace

void CellBatch::gather(const film::FilmState& film, double x_mm, double y_mm, double radius_mm,
                       PassMap* pass) {
    count_ = 0;
    parts_.clear();
    const Disc disc = {x_mm / film.cell_mm - 0.5, y_mm / film.cell_mm - 0.5, radius_mm / film.cell_mm};
    cells_ = grid::intersection(film.shape.cells(), cells_within(disc));
    if (cells_.empty()) return;
    reserve(cells_.width() * cells_.height());
    const grid::Rect tiles = film.shape.tiles_touching(cells_);
    for (int row = tiles.y0; row < tiles.y1; ++row) {
        for (int column = tiles.x0; column < tiles.x1; ++column) {
            const int tile = row * film.shape.tiles_x() + column;
            const int begin = count_;
            const int x0 = column * grid::kTileSize, y0 = row * grid::kTileSize;
            const grid::Rect part =
                grid::intersection(cells_, {x0, y0, x0 + grid::kTileSize, y0 + grid::kTileSize});
            const PassTile passed = pass != nullptr ? pass->tile(tile) : PassTile{};
            gather_part(film, tile, part, disc, passed);
            parts_.push_back({tile, begin, count_, passed.found});
        }
    }
    pad();
}

void CellBatch::gather_part(const film::FilmState& film, int tile, const grid::Rect& part,
                            const Disc& disc, const PassTile& pass) {
    const GatherSource source = {film.thickness.read(tile), film.support_mm.read(tile),
                                 film.paint.read(tile), pass};
    count_ += core::kernels<GatherKernels>().gather(source, part, disc, film.cell_mm,
                                                    {&dx_mm[count_], &dy_mm[count_], &support_mm[count_],
                                                     &thickness[count_], &found[count_], &cell[count_]});
}

void CellBatch::reserve(int count) {
    const auto size = static_cast<std::size_t>(count) + kBatchStep;
    if (cell.size() >= size) return;
    for (auto* column : {&dx_mm, &dy_mm, &support_mm, &touched})
        column->resize(size);
    for (auto* column : {&thickness, &found, &cell, &change, &swap})
        column->resize(size);
}

void CellBatch::pad() {
    // More than needed, since a fixed number is faster.
    for (float* column : {&dx_mm[count_], &dy_mm[count_]})
        std::fill_n(column, kBatchStep, 0.0F);
    for (std::int32_t* column : {&thickness[count_], &found[count_], &cell[count_]})
        std::fill_n(column, kBatchStep, 0);
    std::fill_n(&support_mm[count_], kBatchStep, kUnreachable_mm);
}

}  // namespace pastoso::brush
