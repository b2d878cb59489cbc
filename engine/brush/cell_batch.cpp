#include "brush/cell_batch.hpp"

#include <algorithm>

namespace pastoso::brush {

namespace {

/// Outlines are worked out for whole registers of rows.
constexpr int kRowStep = 8;
/// A height no tool reaches, for the padding.
constexpr float kUnreachable_mm = -1e6F;

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
    const int rows_of_spans = (cells_.height() + kRowStep - 1) / kRowStep * kRowStep;
    spans_.resize(static_cast<std::size_t>(rows_of_spans));
    rows_.resize(spans_.size());
    core::kernels<GatherKernels>().outline(disc, cells_.y0, rows_of_spans, spans_.data());
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
    int row_count = 0, end = count_;
    for (int y = part.y0; y < part.y1; ++y) {
        const RowSpan& span = spans_[y - cells_.y0];
        const int x0 = std::max(part.x0, span.first);
        const int width = std::min(part.x1, span.end) - x0;
        if (width <= 0) continue;
        rows_[row_count++] = {grid::Shape::cell_in_tile(x0, y), width,
                              static_cast<float>((x0 - disc.x) * film.cell_mm),
                              static_cast<float>((y - disc.y) * film.cell_mm)};
        end += width;
    }
    const GatherSource source = {film.thickness.read(tile), film.support_mm.read(tile),
                                 film.paint.read(tile), pass != nullptr ? pass->tile(tile) : PassTile{}};
    core::kernels<GatherKernels>().gather(source, rows_.data(), row_count,
                                          static_cast<float>(film.cell_mm),
                                          {&dx_mm[count_], &dy_mm[count_], &support_mm[count_],
                                           &thickness[count_], &found[count_], &cell[count_]});
    count_ = end;
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
    // More than needed, since a fixed number is faster.
    for (float* column : {&dx_mm[count_], &dy_mm[count_]})
        std::fill_n(column, kBatchStep, 0.0F);
    for (std::int32_t* column : {&thickness[count_], &found[count_], &cell[count_]})
        std::fill_n(column, kBatchStep, 0);
    std::fill_n(&support_mm[count_], kBatchStep, kUnreachable_mm);
}

}  // namespace pastoso::brush
