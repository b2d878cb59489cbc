// Parcels of milk and the cells around them: what a parcel gives to the tea is shared among the eight
// nearest cells' middles, as far as the tea reaches, by trilinear weights over open cells, scaled to add
// up to 1.
#pragma once

#include "core/lane_memory.hpp"
#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"
#include "liquid/tea/between.hpp"
#include "liquid/tea/parcel.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pastoso::liquid {

inline constexpr std::size_t kParcelsAtOnce = 1024;

/// Calls body(begin, end) for blocks of at most kParcelsAtOnce of the numbers below `count`, on the
/// threads of a pool.
template <class Body>
void for_parcel_blocks(core::ThreadPool& pool, std::size_t count, const Body& body) {
    pool.run((count + kParcelsAtOnce - 1) / kParcelsAtOnce, [&](std::size_t block, int) {
        body(block * kParcelsAtOnce, std::min(count, (block + 1) * kParcelsAtOnce));
    });
}

/// The same for each of the numbers: body(number).
template <class Body>
void for_parcels(core::ThreadPool& pool, std::size_t count, const Body& body) {
    for_parcel_blocks(pool, count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            body(i);
    });
}

/// Puts parcels in the order of the eight cells around them: of the lowest one, x first; those with the
/// same stay in theirs. Positions must be finite and in the box.
class ParcelSorter {
  public:
    explicit ParcelSorter(const grid::BoxShape& shape);
    void sort(std::vector<Parcel>& parcels, core::ThreadPool& pool);

  private:
    void order_by_layers(std::span<const Parcel> parcels, core::ThreadPool& pool);
    void sort_layer(std::span<const Parcel> parcels, std::size_t layer);

    grid::BoxShape shape_;
    std::size_t layers_, layer_cells_;
    std::vector<std::uint32_t> cells_;     ///< of each parcel, in its layer
    std::vector<std::uint16_t> layer_of_;  ///< of each parcel
    std::vector<std::uint32_t> by_layer_;  ///< numbers of parcels
    std::vector<std::uint32_t> begins_;    ///< of each layer in those, and their end
    std::vector<Parcel> sorted_;
};

/// The fields that parcels are shared out to, and what a parcel adds to each of them in all.
inline constexpr std::size_t kSharedFields = 4;
using SharedFields = std::array<grid::BoxField*, kSharedFields>;
using SharedAmounts = std::array<float, kSharedFields>;

/// Eight cells (2 x 2 x 2, x first), and what is to be added to them.
class EightCells {
  public:
    explicit EightCells(const grid::BoxField& open_cells);

    /// Goes to the cells around a place; what they had goes to the fields.
    void move_to(const glm::vec3& place_m, const SharedFields& fields) {
        const grid::BoxShape& shape = open_cells_->shape();
        x_ = between_middles(place_m.x / shape.cell_m);
        y_ = between_middles(place_m.y / shape.cell_m);
        z_ = between_middles(place_m.z / shape.cell_m);
        const std::ptrdiff_t first = shape.index(x_.lower, y_.lower, z_.lower);
        if (first == first_) return;
        flush(fields);
        enter(first);
    }
    bool any_open() const { return any_open_; }
    void add(const SharedAmounts& amounts) {
        const Four xy = Four{1.0F - x_.part, x_.part, 1.0F - x_.part, x_.part} *
                        Four{1.0F - y_.part, 1.0F - y_.part, y_.part, y_.part};
        const Four low = xy * Four(1.0F - z_.part) * open_[0], high = xy * Four(z_.part) * open_[1];
        const Four both = low + high;
        const Four sum = Four((both[0] + both[1]) + (both[2] + both[3]));
        const Four low_share = low / sum, high_share = high / sum;
        for (std::size_t f = 0; f < kSharedFields; ++f) {
            added_[f][0] += Four(amounts[f]) * low_share;
            added_[f][1] += Four(amounts[f]) * high_share;
        }
    }
    void flush(const SharedFields& fields);

  private:
    using Four = core::lanes::Lanes<float, 4>;
    void enter(std::ptrdiff_t first);

    const grid::BoxField* open_cells_;
    std::array<std::ptrdiff_t, 8> offsets_;
    std::ptrdiff_t first_ = -1;  ///< index of the lowest; negative: none yet
    Between x_{}, y_{}, z_{};
    Four open_[2]{Four(0.0F), Four(0.0F)};
    bool any_open_ = false;
    Four added_[kSharedFields][2];
};

/// fields[n] += amounts_of(parcel)[n] times the parcel's shares, one parcel after the other; those with
/// no open cell around them are left out.
template <class AmountsOf>
void share_out(std::span<Parcel> parcels, const grid::BoxField& open_cells, const SharedFields& fields,
               const AmountsOf& amounts_of) {
    EightCells cells(open_cells);
    for (Parcel& parcel : parcels) {
        cells.move_to(parcel.position_m, fields);
        if (cells.any_open()) cells.add(amounts_of(parcel));
    }
    cells.flush(fields);
}

/// The parcels of every pair of layers, of sorted ones.
std::vector<std::span<Parcel>> parcel_slabs(const grid::BoxShape& shape, std::span<Parcel> sorted);

/// The same on the threads of a pool, of sorted parcels: those of every second pair of layers and then
/// the others, so that a cell gets its shares in the same order on any number of threads.
template <class AmountsOf>
void share_out_sorted(std::span<Parcel> sorted, const grid::BoxField& open_cells,
                      const SharedFields& fields, core::ThreadPool& pool, const AmountsOf& amounts_of) {
    const std::vector<std::span<Parcel>> slabs = parcel_slabs(open_cells.shape(), sorted);
    // Slabs of two layers reach into a third one: every second slab can be worked on at once.
    for (const std::size_t parity : {0U, 1U})
        pool.run((slabs.size() + 1 - parity) / 2, [&](std::size_t pair, int) {
            share_out(slabs[2 * pair + parity], open_cells, fields, amounts_of);
        });
}

}  // namespace pastoso::liquid
