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

}  // namespace

std::size_t mask_bytes(grid::Shape shape) {
    return (index_of(shape, 0, shape.height) + 7) / 8;
}

packing::Bytes mask_bits(const grid::Mask& mask) {
    const grid::Shape shape = mask.shape();
    packing::Bytes bits(mask_bytes(shape));
    for (int tile = 0; tile < mask.tile_count(); ++tile) {
        const std::uint8_t* chosen = mask.read(tile);
        for_cells(shape.tile_cells(tile), [&](int x, int y) {
            const std::size_t index = index_of(shape, x, y);
            bits[index / 8] |= std::byte{chosen[grid::Shape::cell_in_tile(x, y)]} << index % 8;
        });
    }
    return bits;
}

grid::Mask mask_of_bits(grid::Shape shape, std::span<const std::byte> bits) {
    PASTOSO_CHECK_OP(bits.size(), ==, mask_bytes(shape));
    grid::MaskBuilder builder(shape);
    for (int tile = 0; tile < shape.tile_count(); ++tile) {
        std::array<std::uint8_t, grid::kTileCells> chosen{};
        for_cells(shape.tile_cells(tile), [&](int x, int y) {
            const std::size_t index = index_of(shape, x, y);
            const std::byte bit = bits[index / 8] >> index % 8 & std::byte{1};
            chosen[grid::Shape::cell_in_tile(x, y)] = std::to_integer<std::uint8_t>(bit);
        });
        builder.set_tile(tile, chosen.data());
    }
    return builder.take();
}

}  // namespace pastoso::project
