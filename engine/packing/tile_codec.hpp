// A tile's values in a lossless form that compresses well (docs/file-format.md, "Tiles").
#pragma once

#include "core/kernels.hpp"
#include "grid/shape.hpp"

#include <cstddef>
#include <cstdint>

namespace pastoso::packing {

/// Bytes of a tile of `channels` 32-bit words a cell, in either form.
inline constexpr std::size_t tile_bytes(int channels) {
    return sizeof(std::uint32_t) * static_cast<std::size_t>(channels) * grid::kTileCells;
}

/// What the words of a cell are expected to be.
struct Expectation {
    /// The words are amounts in proportion to it, cell by cell. Null: they are what the neighbour's are.
    const std::int32_t* amount = nullptr;
    /// The surface of a liquid, as it were: one word a cell, a signed integer, without `amount`.
    bool smooth = false;
};

/// Of every word, the difference from what its neighbour leads to expect: the cell to the left, in the
/// first column the one above, in the first cell 0. Differences are folded (0, -1, 1, -2 ... become 0,
/// 1, 2, 3 ...) and stored channel by channel, lowest bytes first: 4096 lowest bytes, 4096 second bytes,
/// ...
///
/// Where an amount is given, expected is the neighbour's times amount / neighbour's amount. With a cell
/// to the left and one above, paints mix on the line from the first to the second: how far, -1 to 1, is
/// learned of the channel in which they differ most, the others follow. Paint of one kind leaves nearly
/// nothing, two half-mixed ones little.
///
/// Of smooth words, with cells to the left a, above b, and above that to the left c, expected is the
/// median of a, b and a + b - c (Weinberger, Seroussi and Sapiro, LOCO-I, 2000).
///
/// `words` and the bytes hold tile_bytes(channels); there are 1, 6, 9, 12 or 16 channels.
struct TileCodec {
    void (*encode)(const std::uint32_t* words, int channels, const Expectation& expected,
                   std::byte* out);
    /// The inverse, with the same expectation; any bytes give some words.
    void (*decode)(const std::byte* in, int channels, const Expectation& expected, std::uint32_t* words);

    /// All give the same bytes.
    static const TileCodec baseline, avx2, avx512;
};

}  // namespace pastoso::packing
