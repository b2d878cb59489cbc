#include "liquid/tea/parcel_cells.hpp"

#include "core/check.hpp"

#include <numeric>
#include <utility>

namespace pastoso::liquid {
namespace {

constexpr std::size_t kBlock = 4096;
constexpr int kSlabLayers = 2;

std::size_t block_count(std::size_t parcels) {
    return (parcels + kBlock - 1) / kBlock;
}

/// The lowest of the eight cells around a parcel, from the one before the box on.
struct LowestCell {
    int x, y, z;
};
LowestCell lowest_cell(const grid::BoxShape& shape, const glm::vec3& at) {
    // With half a cell to spare: the box' side is rounded.
    const auto lies_in_box = [&](float along, int cells) {
        return along > -0.5F * shape.cell_m && along < (static_cast<float>(cells) + 0.5F) * shape.cell_m;
    };
    PASTOSO_CHECK(lies_in_box(at.x, shape.nx) && lies_in_box(at.y, shape.ny) &&
                  lies_in_box(at.z, shape.nz));
    return {between_middles(at.x / shape.cell_m).lower + 1,
            between_middles(at.y / shape.cell_m).lower + 1,
            between_middles(at.z / shape.cell_m).lower + 1};
}

}  // namespace

ParcelSorter::ParcelSorter(const grid::BoxShape& shape)
    : shape_(shape),
      layers_(static_cast<std::size_t>(shape.nz) + 1),
      layer_cells_((static_cast<std::size_t>(shape.nx) + 1) * (static_cast<std::size_t>(shape.ny) + 1)) {
}

/// A counting sort, block by block.
void ParcelSorter::order_by_layers(std::span<const Parcel> parcels, core::ThreadPool& pool) {
    const std::size_t blocks = block_count(parcels.size());
    std::vector<std::uint32_t> next(blocks * layers_, 0);
    const auto for_blocks = [&](const auto& body) {
        pool.run(blocks, [&](std::size_t block, int) {
            for (std::size_t i = block * kBlock; i < std::min(parcels.size(), (block + 1) * kBlock); ++i)
                body(block, i);
        });
    };
    for_blocks([&](std::size_t block, std::size_t i) {
        const LowestCell cell = lowest_cell(shape_, parcels[i].position_m);
        cells_[i] = static_cast<std::uint32_t>(cell.y * (shape_.nx + 1) + cell.x);
        layer_of_[i] = static_cast<std::uint16_t>(cell.z);
        ++next[block * layers_ + static_cast<std::size_t>(cell.z)];
    });
    std::uint32_t begin = 0;
    for (std::size_t layer = 0; layer < layers_; ++layer) {
        begins_[layer] = begin;
        for (std::size_t block = 0; block < blocks; ++block) {
            std::uint32_t& count = next[block * layers_ + layer];
            begin += std::exchange(count, begin);
        }
    }
    begins_[layers_] = begin;
    for_blocks([&](std::size_t block, std::size_t i) {
        by_layer_[next[block * layers_ + layer_of_[i]]++] = static_cast<std::uint32_t>(i);
    });
}

void ParcelSorter::sort_layer(std::span<const Parcel> parcels, std::size_t layer) {
    const std::uint32_t begin = begins_[layer], end = begins_[layer + 1];
    if (begin == end) return;
    std::vector<std::uint32_t> next(layer_cells_ + 1, 0);
    for (std::uint32_t n = begin; n < end; ++n)
        ++next[cells_[by_layer_[n]] + 1];
    next[0] = begin;
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::uint32_t n = begin; n < end; ++n)
        sorted_[next[cells_[by_layer_[n]]]++] = parcels[by_layer_[n]];
}

void ParcelSorter::sort(std::vector<Parcel>& parcels, core::ThreadPool& pool) {
    cells_.resize(parcels.size());
    layer_of_.resize(parcels.size());
    by_layer_.resize(parcels.size());
    sorted_.resize(parcels.size());
    begins_.resize(layers_ + 1);
    order_by_layers(parcels, pool);
    pool.run(layers_, [&](std::size_t layer, int) { sort_layer(parcels, layer); });
    parcels.swap(sorted_);
}

EightCells::EightCells(const grid::BoxField& open_cells) : open_cells_(&open_cells) {
    const grid::BoxShape& shape = open_cells.shape();
    for (std::size_t corner = 0; corner < offsets_.size(); ++corner)
        offsets_[corner] = static_cast<std::ptrdiff_t>(corner & 1) +
                           static_cast<std::ptrdiff_t>(corner >> 1 & 1) * shape.stride_y() +
                           static_cast<std::ptrdiff_t>(corner >> 2) * shape.stride_z();
    for (auto& added : added_)
        added[0] = added[1] = Four(0.0F);
}

void EightCells::enter(std::ptrdiff_t first) {
    first_ = first;
    std::array<float, 8> open;
    for (std::size_t corner = 0; corner < open.size(); ++corner)
        open[corner] = open_cells_->values()[static_cast<std::size_t>(first + offsets_[corner])];
    open_[0] = core::lanes::load<Four>(open.data());
    open_[1] = core::lanes::load<Four>(open.data() + 4);
    any_open_ = std::any_of(open.begin(), open.end(), [](float share) { return share > 0.0F; });
}

void EightCells::flush(const SharedFields& fields) {
    if (first_ < 0 || !any_open_) return;
    for (std::size_t f = 0; f < kSharedFields; ++f) {
        float* values = fields[f]->values().data() + first_;
        for (int corner = 0; corner < 8; ++corner)
            values[offsets_[static_cast<std::size_t>(corner)]] += added_[f][corner / 4][corner % 4];
        added_[f][0] = added_[f][1] = Four(0.0F);
    }
}

std::vector<std::span<Parcel>> parcel_slabs(const grid::BoxShape& shape, std::span<Parcel> sorted) {
    std::vector<std::span<Parcel>> slabs;
    for (auto begin = sorted.begin(); begin != sorted.end() || slabs.empty();) {
        const int slab = static_cast<int>(slabs.size());
        const auto end = std::partition_point(begin, sorted.end(), [&](const Parcel& parcel) {
            return lowest_cell(shape, parcel.position_m).z / kSlabLayers <= slab;
        });
        slabs.emplace_back(begin, end);
        begin = end;
    }
    return slabs;
}

}  // namespace pastoso::liquid
