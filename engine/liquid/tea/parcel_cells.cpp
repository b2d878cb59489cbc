#include "liquid/tea/parcel_cells.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::liquid {
namespace {

constexpr std::size_t kParcelsAtOnce = 512;

/// Where the eight cells lie from the first.
std::array<std::ptrdiff_t, 8> corner_offsets(const grid::BoxShape& shape) {
    std::array<std::ptrdiff_t, 8> offsets;
    for (std::size_t corner = 0; corner < 8; ++corner)
        offsets[corner] = static_cast<std::ptrdiff_t>(corner & 1) +
                          static_cast<std::ptrdiff_t>(corner >> 1 & 1) * shape.stride_y() +
                          static_cast<std::ptrdiff_t>(corner >> 2) * shape.stride_z();
    return offsets;
}

/// The lower of two neighbouring middles along an axis, and how far on to the upper one.
struct Between {
    int lower;
    float part;
};

Between between_middles(float position_m, float cell_m) {
    const float cells = position_m / cell_m - 0.5F;
    const float lower = std::floor(cells);
    return {static_cast<int>(lower), cells - lower};
}

ParcelShares shares_of(const Parcel& parcel, const grid::BoxField& open_cells,
                       const std::array<std::ptrdiff_t, 8>& offsets) {
    const grid::BoxShape& shape = open_cells.shape();
    const glm::vec3& at = parcel.position_m;
    PASTOSO_CHECK(std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z));
    const Between x = between_middles(at.x, shape.cell_m), y = between_middles(at.y, shape.cell_m),
                  z = between_middles(at.z, shape.cell_m);
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
    pool.run((parcels.size() + kParcelsAtOnce - 1) / kParcelsAtOnce, [&](std::size_t batch, int) {
        const std::size_t end = std::min(parcels.size(), (batch + 1) * kParcelsAtOnce);
        for (std::size_t i = batch * kParcelsAtOnce; i < end; ++i)
            shares[i] = shares_of(parcels[i], open_cells, offsets);
    });
}

void scatter(std::span<const ParcelShares> shares, std::span<const float> amounts,
             grid::BoxField& field) {
    PASTOSO_CHECK_OP(shares.size(), ==, amounts.size());
    const auto offsets = corner_offsets(field.shape());
    float* values = field.values().data();
    for (std::size_t i = 0; i < shares.size(); ++i)
        for (std::size_t corner = 0; corner < 8; ++corner)
            values[shares[i].first + offsets[corner]] += amounts[i] * shares[i].shares[corner];
}

}  // namespace pastoso::liquid
