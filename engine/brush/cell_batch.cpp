#include "brush/cell_batch.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

/// A height no tool reaches, for the padding.
constexpr float kUnreachable_mm = -1e6F;

/// Cells of a row that are gathered at once.
constexpr int kBlock = 8;
static_assert(kBlock <= kBatchStep);

int whole_below(double x) {
    const int truncated = static_cast<int>(x);
    return truncated - (truncated > x ? 1 : 0);
}

/// First and one-past-last cell whose centre lies within `reach_mm` of `place_mm`.
struct Span {
    int first, end;
};
Span cells_within(double place_mm, double reach_mm, double cell_mm) {
    const double farthest = 1e6;
    const double first = std::clamp((place_mm - reach_mm) / cell_mm - 0.5, -farthest, farthest);
    const double last = std::clamp((place_mm + reach_mm) / cell_mm - 0.5, -farthest, farthest);
    return {-whole_below(-first), whole_below(last) + 1};
}

}  // namespace

void CellBatch::gather(const film::FilmState& film, double x_mm, double y_mm, double radius_mm,
                       PassMap* pass) {
    count_ = 0;
    parts_.clear();
    const Span columns = cells_within(x_mm, radius_mm, film.cell_mm);
    const Span rows = cells_within(y_mm, radius_mm, film.cell_mm);
    cells_ = grid::intersection(film.shape.cells(), {columns.first, rows.first, columns.end, rows.end});
    if (cells_.empty()) return;
    reserve(cells_.width() * cells_.height());
    const Disc disc = {x_mm / film.cell_mm - 0.5, y_mm / film.cell_mm - 0.5, radius_mm / film.cell_mm};
    const grid::Rect tiles = film.shape.tiles_touching(cells_);
    for (int row = tiles.y0; row < tiles.y1; ++row) {
        for (int column = tiles.x0; column < tiles.x1; ++column) {
            const int tile = row * film.shape.tiles_x() + column;
            const int begin = count_;
            const grid::Rect part = grid::intersection(cells_, film.shape.tile_cells(tile));
            gather_part(film, tile, part, disc, pass);
            parts_.push_back({tile, begin, count_});
        }
    }
    pad();
}

void CellBatch::gather_part(const film::FilmState& film, int tile, const grid::Rect& part,
                            const Disc& disc, PassMap* pass) {
    const std::int32_t* tile_thickness = film.thickness.read(tile);
    const film::PaintCell* tile_paint = film.paint.read(tile);
    const float* tile_support = film.support_mm.read(tile);
    const auto cell_mm = static_cast<float>(film.cell_mm);
    for (int y = part.y0; y < part.y1; ++y) {
        const double off = y - disc.y;
        const double half = std::sqrt(std::max(0.0, disc.radius * disc.radius - off * off));
        const int x0 = std::max(part.x0, -whole_below(half - disc.x));
        const int width = std::min(part.x1, whole_below(disc.x + half) + 1) - x0;
        if (width <= 0) continue;
        const auto row_mm = static_cast<float>(off * film.cell_mm);
        const auto first_mm = static_cast<float>((x0 - disc.x) * film.cell_mm);
        const int first = grid::Shape::cell_in_tile(x0, y);
        float *dx = &dx_mm[count_], *dy = &dy_mm[count_], *support = &support_mm[count_];
        std::int32_t *quanta = &thickness[count_], *index = &cell[count_];
        const auto take = [&](int begin, int end) {
#pragma GCC ivdep  // the columns do not overlap
            for (int i = begin; i < end; ++i) {
                dx[i] = first_mm + static_cast<float>(i) * cell_mm;
                dy[i] = row_mm;
                quanta[i] = tile_thickness[first + i];
                support[i] = tile_support[first + i];
                index[i] = first + i;
            }
        };
        // Whole blocks are fastest; what is too much is overwritten by the next row. Not beyond the
        // tile.
        int done = 0;
        for (; done < width && first + done + kBlock <= grid::kTileCells; done += kBlock)
            take(done, done + kBlock);
        take(done, width);
        if (pass != nullptr)
            pass->find(tile, first, width, quanta, &found[count_]);
        else
            std::copy_n(quanta, width, &found[count_]);
        // The exchange will want the paint of these cells soon.
        for (int i = 0; i < width; ++i)
            __builtin_prefetch(&tile_paint[first + i], 1);
        count_ += width;
    }
}

void CellBatch::reserve(int count) {
    const auto size = static_cast<std::size_t>(count) + kBatchStep;
    if (cell.size() >= size) return;
    for (auto* column : {&dx_mm, &dy_mm, &support_mm})
        column->resize(size);
    for (auto* column : {&thickness, &found, &cell, &change, &swap})
        column->resize(size);
}

void CellBatch::pad() {
    for (int i = count_; i < padded_count(); ++i) {
        dx_mm[i] = dy_mm[i] = 0.0F;
        thickness[i] = found[i] = cell[i] = 0;
        support_mm[i] = kUnreachable_mm;
    }
}

}  // namespace pastoso::brush
