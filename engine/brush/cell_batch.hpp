// The cells under a tool's footprint, gathered from the tiles into plain columns for the kernels.
#pragma once

#include "brush/gather_kernel.hpp"
#include "brush/pass_map.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::brush {

/// The columns are padded to a multiple of this with cells that nothing reaches.
inline constexpr int kBatchStep = 16;

/// Reused from footprint to footprint; valid until the film changes.
class CellBatch {
  public:
    /// Tools may change the cells of the mask alone, which outlives the batch, and with each exchange
    /// its share of what they would; null: all of them.
    explicit CellBatch(const grid::Mask* limit = nullptr) : limit_(limit) {}

    /// The cells of one tile, as a range of the columns.
    struct TilePart {
        int tile, begin, end;
        std::int32_t* pass_found = nullptr;  ///< PassTile::found
        bool changes = false;                ///< to be filled: something is planned for one of them
        bool has_strata = false;  ///< to be filled: one has two wet strata, or is to have them
    };

    /// Gathers the cells on the canvas whose centres lie within `radius_mm` of a place, and what a pass
    /// found in them (without one: what they hold).
    void gather(const film::FilmState& film, double x_mm, double y_mm, double radius_mm,
                PassMap* pass = nullptr);

    int count() const { return count_; }
    bool is_limited() const { return limit_ != nullptr; }
    /// Of the cell, as grid::Mask has it.
    std::uint8_t share(const TilePart& part, int i) const {
        return limit_ == nullptr ? grid::kWhole : limit_->read(part.tile)[cell[i]];
    }
    bool may_change(const TilePart& part, int i) const { return share(part, i) != 0; }

    int padded_count() const { return (count_ + kBatchStep - 1) / kBatchStep * kBatchStep; }
    const std::vector<TilePart>& parts() const { return parts_; }
    std::vector<TilePart>& parts() { return parts_; }
    const grid::Rect& cells() const { return cells_; }  ///< that hold the whole batch

    /// Columns of padded_count() values.
    std::vector<float> dx_mm, dy_mm;      ///< from the place to the cell's centre
    std::vector<std::int32_t> thickness;  ///< quanta
    std::vector<std::int32_t> found;      ///< as PassTile has it
    std::vector<float> support_mm;
    std::vector<std::int32_t> cell;    ///< index within its tile
    std::vector<std::int32_t> change;  ///< to be filled: wanted change of thickness, quanta
    std::vector<std::int32_t> swap;    ///< to be filled: amount to be exchanged besides, quanta
    std::vector<float> touched;        ///< to be filled: share of the exchange that happens, 0 to 1

  private:
    void gather_part(const film::FilmState& film, int tile, const grid::Rect& part, const Disc& disc,
                     const PassTile& pass);
    void reserve(int count);
    void pad();

    const grid::Mask* limit_;
    int count_ = 0;
    std::vector<TilePart> parts_;
    grid::Rect cells_;
};

}  // namespace pastoso::brush
