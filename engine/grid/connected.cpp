#include "grid/connected.hpp"

namespace pastoso::grid {
namespace {

struct Cell {
    int x, y;
};

/// Fills run after run of cells in a row, and keeps a list of where others begin.
class Flood {
  public:
    explicit Flood(const Mask& mask) : mask_(mask), reached_(mask.shape()) {}

    void from(Cell start) {
        if (is_open(start)) waiting_.push_back(start);
        while (!waiting_.empty()) {
            const Cell next = waiting_.back();
            waiting_.pop_back();
            if (is_open(next)) fill_run(next);
        }
    }

    Mask take() {
        MaskBuilder builder(mask_.shape());
        for (int tile = 0; tile < reached_.tile_count(); ++tile)
            builder.set_tile(tile, reached_.read(tile));
        return builder.take();
    }

  private:
    bool is_open(Cell cell) const {
        return is_chosen(mask_.at(cell.x, cell.y)) && reached_.at(cell.x, cell.y) == 0;
    }

    void fill_run(Cell within) {
        int begin = within.x, end = within.x + 1;
        while (begin > 0 && is_open({begin - 1, within.y}))
            --begin;
        while (end < mask_.shape().width && is_open({end, within.y}))
            ++end;
        for (int x = begin; x < end; ++x)
            reached_.set(x, within.y, kWhole);
        if (within.y > 0) look_along(begin, end, within.y - 1);
        if (within.y + 1 < mask_.shape().height) look_along(begin, end, within.y + 1);
    }

    void look_along(int begin, int end, int y) {
        bool in_run = false;
        for (int x = begin; x < end; ++x) {
            const bool open = is_open({x, y});
            if (open && !in_run) waiting_.push_back({x, y});
            in_run = open;
        }
    }

    const Mask& mask_;
    Mask reached_;
    std::vector<Cell> waiting_;
};

}  // namespace

Mask connected(const Mask& mask, int x, int y) {
    Flood flood(mask);
    flood.from({x, y});
    return flood.take();
}

}  // namespace pastoso::grid
