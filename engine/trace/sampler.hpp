// The random numbers of one sample of one pixel: a pure function of (seed, pixel, sample), so that
// neither threads nor passes change them. The first pairs, which decide where a path goes before it
// scatters, are spread evenly over the samples of a pixel: Sobol's first two dimensions, shuffled and
// scrambled after Owen by hashing (Burley 2020, "Practical hash-based Owen scrambling"). The rest is a
// PCG stream (O'Neill 2014).
#pragma once

#include "core/random.hpp"

#include <cstdint>

#include <glm/vec2.hpp>

namespace pastoso::trace {

/// The two coordinates of point `index` of Sobol's sequence, in units of 2^-32.
struct SobolPoint {
    std::uint32_t x, y;
};

constexpr std::uint32_t reversed_bits(std::uint32_t v) {
    v = ((v >> 1) & 0x55555555U) | ((v & 0x55555555U) << 1);
    v = ((v >> 2) & 0x33333333U) | ((v & 0x33333333U) << 2);
    v = ((v >> 4) & 0x0F0F0F0FU) | ((v & 0x0F0F0F0FU) << 4);
    return __builtin_bswap32(v);
}

/// The second dimension's matrix is Pascal's triangle modulo 2, which halves into copies of itself.
constexpr SobolPoint sobol_point(std::uint32_t index) {
    std::uint32_t v = index;
    v ^= v >> 16;
    v ^= (v & 0xFF00FF00U) >> 8;
    v ^= (v & 0xF0F0F0F0U) >> 4;
    v ^= (v & 0xCCCCCCCCU) >> 2;
    v ^= (v & 0xAAAAAAAAU) >> 1;
    return {reversed_bits(index), reversed_bits(v)};
}

/// A random permutation in which every bit depends on the higher ones alone (Owen 1995).
constexpr std::uint32_t owen_scrambled(std::uint32_t value, std::uint32_t seed) {
    std::uint32_t v = reversed_bits(value);
    v ^= v * 0x3d20adeaU;
    v += seed;
    v *= (seed >> 16) | 1U;
    v ^= v * 0x05526c56U;
    v ^= v * 0x53a22864U;
    return reversed_bits(v);
}

class Sampler {
  public:
    Sampler(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample)
        : pixel_(core::scramble(pixel ^ core::scramble(seed ^ 0x68bc21ebU))), sample_(sample) {
        state_ = (static_cast<std::uint64_t>(pixel_) << 32 | core::scramble(pixel_ + sample)) *
                     6364136223846793005ULL +
                 1442695040888963407ULL;
        random_bits();
    }

    /// The next two numbers, each in [0, 1).
    glm::vec2 pair() {
        if (pairs_ == kEvenPairs) {
            const float first = next();
            return {first, next()};
        }
        const std::uint32_t key = core::scramble(pixel_ + 0x9E3779B9U * ++pairs_);
        const SobolPoint point = sobol_point(owen_scrambled(sample_, key));
        return {unit(owen_scrambled(point.x, core::scramble(key ^ 0xa511e9b3U))),
                unit(owen_scrambled(point.y, core::scramble(key ^ 0x63d83595U)))};
    }

    /// The next number of the stream alone, in [0, 1).
    float next() { return unit(random_bits()); }

  private:
    static constexpr std::uint32_t kEvenPairs = 8;

    static float unit(std::uint32_t bits) {
        return static_cast<float>(bits >> 8) * (1.0F / 16777216.0F);
    }

    std::uint32_t random_bits() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        const auto mixed = static_cast<std::uint32_t>(((state_ >> 18U) ^ state_) >> 27U);
        const auto turn = static_cast<std::uint32_t>(state_ >> 59U);
        return (mixed >> turn) | (mixed << ((32U - turn) & 31U));
    }

    std::uint64_t state_;
    std::uint32_t pixel_, sample_, pairs_ = 0;
};

}  // namespace pastoso::trace
