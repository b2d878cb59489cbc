// The values of a tile as words for the codec, whatever their type.
#pragma once

#include "grid/tile_block.hpp"
#include "packing/tile_codec.hpp"

#include <array>
#include <cstring>
#include <type_traits>
#include <vector>

namespace pastoso::packing {

/// 32-bit words of a cell.
template <class Value>
inline constexpr int kChannels = static_cast<int>(sizeof(Value) / sizeof(std::uint32_t));

template <class Value>
inline constexpr bool kIsWhole = std::is_same_v<Value, std::int32_t>;
template <std::size_t kCount>
inline constexpr bool kIsWhole<std::array<std::int32_t, kCount>> = true;

/// Writes tile_bytes(kChannels<Value>). Integers are words as they are; floats go through memcpy.
template <class Value>
void encode_values(const Value* values, const Expectation& expected, std::byte* out) {
    if constexpr (kIsWhole<Value>) {
        core::kernels<TileCodec>().encode(reinterpret_cast<const std::uint32_t*>(values),
                                          kChannels<Value>, expected, out);
    } else {
        std::vector<std::uint32_t> words(grid::kTileCells * kChannels<Value>);
        std::memcpy(words.data(), values, tile_bytes(kChannels<Value>));
        core::kernels<TileCodec>().encode(words.data(), kChannels<Value>, expected, out);
    }
}

template <class Value>
grid::TileBlock<Value> decoded_values(const std::byte* in, const Expectation& expected) {
    auto block = grid::TileBlock<Value>::uninitialised();
    if constexpr (kIsWhole<Value>) {
        core::kernels<TileCodec>().decode(in, kChannels<Value>, expected,
                                          reinterpret_cast<std::uint32_t*>(block.write()));
    } else {
        std::vector<std::uint32_t> words(grid::kTileCells * kChannels<Value>);
        core::kernels<TileCodec>().decode(in, kChannels<Value>, expected, words.data());
        std::memcpy(static_cast<void*>(block.write()), words.data(), tile_bytes(kChannels<Value>));
    }
    return block;
}

}  // namespace pastoso::packing
