#include "project/mask_bits.hpp"

#include "core/check.hpp"

#include <array>

namespace pastoso::project {
namespace {

std::size_t index_of(grid::Shape shape, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.width) +
           static_cast<std::size_t>(x);
}

template <class Visit>
void for_cells(const grid::Rect& cells, const Visit& visit) {
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x)
            visit(x, y);
}

/// Calls `visit` with the index and the share of every cell of the canvas.
template <class Visit>
void for_shares(const grid::Mask& mask, const Visit& visit) {
    for (int tile = 0; tile < mask.tile_count(); ++tile) {
        const std::uint8_t* shares = mask.read(tile);
        for_cells(mask.shape().tile_cells(tile), [&](int x, int y) {
            visit(index_of(mask.shape(), x, y), shares[grid::Shape::cell_in_tile(x, y)]);
        });
    }
}

/// Of the shares that `share_at(index)` tells.
template <class ShareAt>
grid::Mask mask_of_shares(grid::Shape shape, const ShareAt& share_at) {
    grid::MaskBuilder builder(shape);
    for (int tile = 0; tile < shape.tile_count(); ++tile) {
        std::array<std::uint8_t, grid::kTileCells> shares{};
        for_cells(shape.tile_cells(tile), [&](int x, int y) {
            shares[grid::Shape::cell_in_tile(x, y)] = share_at(index_of(shape, x, y));
        });
        builder.set_tile(tile, shares.data());
    }
    return builder.take();
}

packing::Bytes bits_of(const grid::Mask& mask) {
    packing::Bytes bits(mask_bytes(mask.shape()));
    for_shares(mask, [&](std::size_t index, std::uint8_t share) {
        if (share == grid::kWhole) bits[index / 8] |= std::byte{1} << index % 8;
    });
    return bits;
}

packing::Bytes shares_of(const grid::Mask& mask) {
    packing::Bytes shares(soft_mask_bytes(mask.shape()));
    for_shares(mask, [&](std::size_t index, std::uint8_t share) { shares[index] = std::byte{share}; });
    return shares;
}

}  // namespace

std::size_t mask_bytes(grid::Shape shape) {
    return (soft_mask_bytes(shape) + 7) / 8;
}

std::size_t soft_mask_bytes(grid::Shape shape) {
    return index_of(shape, 0, shape.height);
}

packing::Bytes mask_content(const grid::Mask& mask) {
    return grid::is_soft(mask) ? shares_of(mask) : bits_of(mask);
}

grid::Mask mask_of_content(grid::Shape shape, std::span<const std::byte> content) {
    if (content.size() != mask_bytes(shape)) {
        PASTOSO_CHECK_OP(content.size(), ==, soft_mask_bytes(shape));
        return mask_of_shares(
            shape, [&](std::size_t index) { return std::to_integer<std::uint8_t>(content[index]); });
    }
    return mask_of_shares(shape, [&](std::size_t index) {
        const bool chosen = (content[index / 8] >> index % 8 & std::byte{1}) != std::byte{0};
        return chosen ? grid::kWhole : std::uint8_t{0};
    });
}

}  // namespace pastoso::project
