#include "liquid/tea/parcel_cells.hpp"

#include "core/check.hpp"
#include "liquid/tea/between.hpp"
#include "liquid/tea/counting_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::liquid {
namespace {

/// Where the eight cells lie from the first.
std::array<std::ptrdiff_t, 8> corner_offsets(const grid::BoxShape& shape) {
    std::array<std::ptrdiff_t, 8> offsets;
    for (std::size_t corner = 0; corner < 8; ++corner)
        offsets[corner] = static_cast<std::ptrdiff_t>(corner & 1) +
                          static_cast<std::ptrdiff_t>(corner >> 1 & 1) * shape.stride_y() +
                          static_cast<std::ptrdiff_t>(corner >> 2) * shape.stride_z();
    return offsets;
}

ParcelShares shares_of(const Parcel& parcel, const grid::BoxField& open_cells,
                       const std::array<std::ptrdiff_t, 8>& offsets) {
    const grid::BoxShape& shape = open_cells.shape();
    const glm::vec3& at = parcel.position_m;
    PASTOSO_CHECK(std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z));
    const Between x = between_middles(at.x / shape.cell_m), y = between_middles(at.y / shape.cell_m),
                  z = between_middles(at.z / shape.cell_m);
    PASTOSO_CHECK(x.lower >= -1 && x.lower < shape.nx && y.lower >= -1 && y.lower < shape.ny &&
                  z.lower >= -1 && z.lower < shape.nz);
    ParcelShares result{shape.index(x.lower, y.lower, z.lower), {}};
    float sum = 0.0F;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const float weight = ((corner & 1) != 0 ? x.part : 1.0F - x.part) *
                             ((corner & 2) != 0 ? y.part : 1.0F - y.part) *
                             ((corner & 4) != 0 ? z.part : 1.0F - z.part);
        const float share =
            weight * open_cells.values()[static_cast<std::size_t>(result.first + offsets[corner])];
        result.shares[corner] = share;
        sum += share;
    }
    if (sum > 0.0F)
        for (float& share : result.shares)
            share /= sum;
    return result;
}

}  // namespace

bool ParcelShares::any() const {
    return std::any_of(shares.begin(), shares.end(), [](float share) { return share > 0.0F; });
}

void compute_shares(std::span<const Parcel> parcels, const grid::BoxField& open_cells,
                    core::ThreadPool& pool, std::vector<ParcelShares>& shares) {
    shares.resize(parcels.size());
    const auto offsets = corner_offsets(open_cells.shape());
    for_parcels(pool, parcels.size(),
                [&](std::size_t i) { shares[i] = shares_of(parcels[i], open_cells, offsets); });
}

void scatter(std::span<const ParcelShares> shares, const std::array<std::span<const float>, 2>& amounts,
             const std::array<grid::BoxField*, 2>& fields, core::ThreadPool& pool) {
    const grid::BoxShape& shape = fields[0]->shape();
    PASTOSO_CHECK(fields[1]->shape() == shape);
    PASTOSO_CHECK(shares.size() == amounts[0].size() && shares.size() == amounts[1].size());
    const auto offsets = corner_offsets(shape);
    // Slabs of two layers reach into a third one: every second slab can be worked on at once.
    const std::ptrdiff_t slab_samples = 2 * shape.stride_z();
    const auto slab_of = [&](const ParcelShares& parcel) {
        return static_cast<std::size_t>(parcel.first / slab_samples);
    };
    const CountingOrder order(shares, shape.sample_count() / slab_samples + 1, slab_of);
    for (const std::size_t parity : {0U, 1U})
        pool.run((order.groups() + 1 - parity) / 2, [&](std::size_t pair, int) {
            for (const std::uint32_t i : order.group(2 * pair + parity))
                for (std::size_t corner = 0; corner < 8; ++corner) {
                    const std::size_t cell = static_cast<std::size_t>(shares[i].first + offsets[corner]);
                    fields[0]->values()[cell] += amounts[0][i] * shares[i].shares[corner];
                    fields[1]->values()[cell] += amounts[1][i] * shares[i].shares[corner];
                }
        });
}

void sort_by_cells(const grid::BoxShape& shape, std::vector<Parcel>& parcels) {
    const auto cell_of = [&](const Parcel& parcel) {
        const glm::ivec3 cell(parcel.position_m / shape.cell_m);
        return static_cast<std::size_t>(shape.index(cell.x, cell.y, cell.z));
    };
    const CountingOrder order(std::span<const Parcel>(parcels), shape.sample_count(), cell_of);
    std::vector<Parcel> sorted;
    sorted.reserve(parcels.size());
    for (const std::uint32_t i : order.all())
        sorted.push_back(parcels[i]);
    parcels = std::move(sorted);
}

}  // namespace pastoso::liquid
