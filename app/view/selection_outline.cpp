#include "view/selection_outline.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>

namespace pastoso::view {
namespace {

using grid::Rect;
using Row = std::vector<std::uint8_t>;

constexpr int kCoarsestBlock = grid::kTileSize;

int divided_up(int value, int divisor) {
    return (value + divisor - 1) / divisor;
}

/// Rows of blocks from one left of `first` on, zeros beside the canvas.
class BlockRows {
  public:
    BlockRows(const grid::Mask& mask, int block, int first, int last)
        : mask_(mask), block_(block), first_(first - 1), count_(last - first + 2) {}

    void read(int block_y, Row& row) const {
        row.assign(static_cast<std::size_t>(count_), 0);
        const Rect cells = grid::intersection(
            mask_.shape().cells(),
            {first_ * block_, block_y * block_, (first_ + count_) * block_, (block_y + 1) * block_});
        if (cells.empty()) return;
        const Rect tiles = mask_.shape().tiles_touching(cells);
        for (int tile_x = tiles.x0; tile_x < tiles.x1; ++tile_x) {
            const int tile = tiles.y0 * mask_.shape().tiles_x() + tile_x;
            if (grid::chooses_none(mask_, tile)) continue;
            gather(mask_.read(tile), grid::intersection(cells, mask_.shape().tile_cells(tile)), row);
        }
    }

  private:
    /// 1 or 0.
    static std::uint8_t seen(std::uint8_t share) { return grid::is_chosen(share) ? 1 : 0; }

    void gather(const std::uint8_t* chosen, const Rect& cells, Row& row) const {
        const int shift = std::countr_zero(static_cast<unsigned>(block_));
        for (int y = cells.y0; y < cells.y1; ++y) {
            const std::uint8_t* from = chosen + grid::Shape::cell_in_tile(cells.x0, y);
            if (block_ == 1) std::transform(from, from + cells.width(), &row[cells.x0 - first_], seen);
            if (block_ == 1) continue;
            for (int x = cells.x0; x < cells.x1; ++x)
                row[(x >> shift) - first_] |= seen(from[x - cells.x0]);
        }
    }

    const grid::Mask& mask_;
    int block_, first_, count_;
};

/// Goes down the rows of a window of blocks and joins the pieces of border to lines.
class BorderTracer {
  public:
    BorderTracer(const Rect& blocks, std::size_t most_lines)
        : blocks_(blocks),
          most_lines_(most_lines),
          upright_from_(static_cast<std::size_t>(blocks.width()) + 1, kNone) {}

    struct Line {
        int x0, y0, x1, y1;
    };
    const std::vector<Line>& lines() const { return lines_; }
    bool too_many() const { return lines_.size() > most_lines_; }

    /// The border between row y - 1 and row y, and those within row y. Rows begin one block left of the
    /// window. Where two rows are alike, upright borders just go on.
    void trace(int y, const Row& above, const Row& row) {
        constexpr int kPiece = 64;
        const int end = blocks_.width() + 1;
        for (int begin = 0; begin < end; begin += kPiece) {
            const int stop = std::min(begin + kPiece, end);
            const auto bytes = static_cast<std::size_t>(stop - begin + 1);
            const bool alike = std::memcmp(&above[begin], &row[begin], bytes) == 0;
            if (alike && y > blocks_.y0) {
                end_level(begin, y);
                continue;
            }
            for (int x = begin; x < stop; ++x)
                trace_corner(x, y, above, row);
        }
        end_level(blocks_.width(), y);
    }

    void finish() {
        for (std::size_t x = 0; x < upright_from_.size(); ++x)
            end_upright(static_cast<int>(x), blocks_.y1);
    }

  private:
    static constexpr int kNone = std::numeric_limits<int>::min();

    /// Upright left of block x, level above it.
    void trace_corner(int x, int y, const Row& above, const Row& row) {
        const bool upright = y < blocks_.y1 && row[x] != row[x + 1];
        if (!upright) end_upright(x, y);
        if (upright && upright_from_[x] == kNone) upright_from_[x] = y;
        const bool level = x < blocks_.width() && above[x + 1] != row[x + 1];
        if (!level) end_level(x, y);
        if (level && level_from_ == kNone) level_from_ = x;
    }

    void end_level(int x, int y) {
        const int from = std::exchange(level_from_, kNone);
        if (from != kNone) lines_.push_back({blocks_.x0 + from, y, blocks_.x0 + x, y});
    }

    void end_upright(int x, int y) {
        const int from = std::exchange(upright_from_[x], kNone);
        if (from != kNone) lines_.push_back({blocks_.x0 + x, from, blocks_.x0 + x, y});
    }

    Rect blocks_;
    std::size_t most_lines_;
    std::vector<int> upright_from_;  ///< the rows where the borders left of the blocks begin
    int level_from_ = kNone;
    std::vector<Line> lines_;
};

Rect blocks_of(const Rect& cells, int block) {
    return {cells.x0 / block, cells.y0 / block, divided_up(cells.x1, block),
            divided_up(cells.y1, block)};
}

/// The last block may reach beyond the canvas; its border does not.
std::vector<glm::vec2> in_mm(const std::vector<BorderTracer::Line>& lines, grid::Shape shape, int block,
                             double cell_mm) {
    const auto corner_mm = [&](int x, int y) {
        return glm::vec2(cell_mm * std::min(x * block, shape.width),
                         cell_mm * std::min(y * block, shape.height));
    };
    std::vector<glm::vec2> corners;
    corners.reserve(2 * lines.size());
    for (const BorderTracer::Line& line : lines) {
        corners.push_back(corner_mm(line.x0, line.y0));
        corners.push_back(corner_mm(line.x1, line.y1));
    }
    return corners;
}

}  // namespace

std::optional<std::vector<glm::vec2>> mask_borders_mm(const grid::Mask& mask, double cell_mm,
                                                      const MaskWindow& window, std::size_t most_lines) {
    const Rect cells = grid::intersection(mask.shape().cells(), window.cells);
    if (cells.empty()) return std::vector<glm::vec2>{};
    const Rect blocks = blocks_of(cells, window.block);
    const BlockRows rows(mask, window.block, blocks.x0, blocks.x1);
    BorderTracer tracer(blocks, most_lines);
    Row above, row;
    rows.read(blocks.y0 - 1, above);
    for (int y = blocks.y0; y <= blocks.y1; ++y) {
        rows.read(y, row);
        tracer.trace(y, above, row);
        if (tracer.too_many()) return std::nullopt;
        std::swap(above, row);
    }
    tracer.finish();
    if (tracer.too_many()) return std::nullopt;
    return in_mm(tracer.lines(), mask.shape(), window.block, cell_mm);
}

const std::vector<glm::vec2>& SelectionOutline::lines_mm(const document::Selection& selection,
                                                         double cell_mm, const Rect& seen) {
    if (selection != selection_ || cell_mm != cell_mm_) {
        selection_ = selection;
        cell_mm_ = cell_mm;
        make_whole();
    }
    if (whole_) return lines_mm_;
    const Rect tiles = selection_->shape().tiles_touching(seen);
    const Rect around{tiles.x0 * grid::kTileSize, tiles.y0 * grid::kTileSize, tiles.x1 * grid::kTileSize,
                      tiles.y1 * grid::kTileSize};
    if (around != made_for_) make_seen(around);
    return lines_mm_;
}

void SelectionOutline::make_whole() {
    lines_mm_.clear();
    whole_ = true;
    made_for_ = {};
    if (selection_ == nullptr) return;
    auto lines = mask_borders_mm(*selection_, cell_mm_, {selection_->shape().cells()}, kMostLines);
    whole_ = lines.has_value();
    if (lines) lines_mm_ = std::move(*lines);
}

void SelectionOutline::make_seen(const Rect& cells) {
    made_for_ = cells;
    for (int block = 1; block <= kCoarsestBlock; block *= 2) {
        const bool last = block == kCoarsestBlock;
        const std::size_t most = last ? std::numeric_limits<std::size_t>::max() : kMostLines;
        auto lines = mask_borders_mm(*selection_, cell_mm_, {cells, block}, most);
        if (!lines) continue;
        lines_mm_ = std::move(*lines);
        return;
    }
}

}  // namespace pastoso::view
