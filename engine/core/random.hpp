// Reproducible noise: pure functions of integers, the same on every machine and in any order of calls.
#pragma once

#include <cstdint>

namespace pastoso::core {

/// Scrambles 32 bits so that neighbouring inputs give unrelated outputs (a bijection).
constexpr std::uint32_t scramble(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    x ^= x >> 16;
    return x;
}

/// A number in [0, 1) that depends on both integers.
constexpr float uniform_noise(std::uint32_t index, std::uint32_t stream) {
    const std::uint32_t bits = scramble((index * 0x9E3779B9U) ^ scramble(stream));
    return static_cast<float>(bits >> 8) * (1.0F / 16777216.0F);
}

}  // namespace pastoso::core
