// Parcels of milk and the cells around them: what a parcel gives to the tea is shared among the eight
// nearest cells' middles, as far as the tea reaches.
#pragma once

#include "core/thread_pool.hpp"
#include "grid/box_field.hpp"
#include "liquid/tea/parcel.hpp"

#include <array>
#include <span>
#include <vector>

namespace pastoso::liquid {

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

/// field += amount[p] times p's shares, for one parcel after the other.
void scatter(std::span<const ParcelShares> shares, std::span<const float> amounts,
             grid::BoxField& field);

}  // namespace pastoso::liquid
