// Parcels of milk and the cells around them: what a parcel gives to the tea is shared among the eight
// nearest cells' middles, as far as the tea reaches.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"
#include "liquid/tea/parcel.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace pastoso::liquid {

/// Calls body(i) once for each i below `count`, on the threads of a pool.
template <class Body>
void for_parcels(core::ThreadPool& pool, std::size_t count, const Body& body) {
    constexpr std::size_t kAtOnce = 1024;
    pool.run((count + kAtOnce - 1) / kAtOnce, [&](std::size_t batch, int) {
        for (std::size_t i = batch * kAtOnce; i < std::min(count, (batch + 1) * kAtOnce); ++i)
            body(i);
    });
}

/// The eight cells (2 x 2 x 2, x first) and their shares, which are trilinear weights over open cells,
/// scaled to add up to 1; or all 0 where none of the eight is open.
struct ParcelShares {
    std::ptrdiff_t first = 0;  ///< index of the lowest of them
    std::array<float, 8> shares{};

    bool any() const;
};

/// Of all parcels; their positions must be finite and in the box. `open_cells` is 1 in open cells, 0 in
/// others.
void compute_shares(std::span<const Parcel> parcels, const grid::BoxField& open_cells,
                    core::ThreadPool& pool, std::vector<ParcelShares>& shares);

/// fields[n] += amounts[n][p] times p's shares, for both n and all parcels, whose order in each cell is
/// that of the parcels of every second pair of layers and then of the others: the same bits on any
/// number of threads.
void scatter(std::span<const ParcelShares> shares, const std::array<std::span<const float>, 2>& amounts,
             const std::array<grid::BoxField*, 2>& fields, core::ThreadPool& pool);

/// Puts parcels in the order of the cells that they lie in, x first; those of one cell stay in theirs.
void sort_by_cells(const grid::BoxShape& shape, std::vector<Parcel>& parcels);

}  // namespace pastoso::liquid
