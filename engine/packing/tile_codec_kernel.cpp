// Compiled once per instruction set; see pastoso_add_kernels.
#include "core/check.hpp"
#include "packing/tile_codec.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace pastoso::packing::PASTOSO_ISA {
namespace {

using grid::kTileCells;
using grid::kTileSize;

constexpr std::uint32_t folded(std::uint32_t difference) {
    return (difference << 1) ^ (0U - (difference >> 31));
}
constexpr std::uint32_t unfolded(std::uint32_t code) {
    return (code >> 1) ^ (0U - (code & 1U));
}

/// The cell that the next one is expected to resemble.
constexpr int neighbour_of(int cell) {
    return cell % kTileSize != 0 ? cell - 1 : cell - kTileSize;
}

/// amount / neighbour's amount; 1 where the neighbour has none.
double growth(const std::int32_t* amount, int cell, int neighbour) {
    if (amount[neighbour] == 0) return 1.0;
    return static_cast<double>(amount[cell]) / static_cast<double>(amount[neighbour]);
}

std::uint32_t rounded(double exact) {
    constexpr double kLeast = -2147483648.0, kMost = 2147483647.0;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::clamp(exact, kLeast, kMost)));
}

/// The first of the numbers that are farthest from 0. Their magnitudes are compared as bits, which are
/// in the same order, so that the compiler takes several at once.
template <std::size_t kCount>
int place_of_largest(const std::array<double, kCount>& numbers) {
    std::array<std::int64_t, kCount> bits;
    for (std::size_t k = 0; k < kCount; ++k)
        bits[k] = std::bit_cast<std::int64_t>(std::abs(numbers[k]));
    std::int64_t largest = bits[0];
    for (std::size_t k = 1; k < kCount; ++k)
        largest = std::max(largest, bits[k]);
    return static_cast<int>(std::find(bits.begin(), bits.end(), largest) - bits.begin());
}

double number(std::uint32_t word) {
    return static_cast<double>(static_cast<std::int32_t>(word));
}

/// What a cell is expected to hold where its words are no amounts: the neighbour's words.
template <int kChannels>
class PlainGuess {
  public:
    PlainGuess(const std::uint32_t* words, const std::int32_t*, int cell)
        : known_(cell == 0 ? nullptr : words + neighbour_of(cell) * kChannels) {}

    int first() const { return 0; }
    void learn(std::uint32_t) {}
    std::uint32_t operator[](int channel) const { return known_ == nullptr ? 0U : known_[channel]; }

  private:
    const std::uint32_t* known_;
};

/// What a cell of a smooth surface is expected to hold: the median of the neighbours and of the plane
/// through them.
template <int kChannels>
class SmoothGuess {
  public:
    SmoothGuess(const std::uint32_t* words, const std::int32_t*, int cell) {
        static_assert(kChannels == 1);
        if (cell == 0) return;
        guess_ = words[neighbour_of(cell)];
        if (cell < kTileSize || cell % kTileSize == 0) return;
        const auto at = [&](int other) { return static_cast<std::int32_t>(words[other]); };
        const std::int32_t left = at(cell - 1), above = at(cell - kTileSize),
                           corner = at(cell - kTileSize - 1);
        const std::int32_t low = std::min(left, above), high = std::max(left, above);
        if (corner >= high)
            guess_ = static_cast<std::uint32_t>(low);
        else if (corner <= low)
            guess_ = static_cast<std::uint32_t>(high);
        else
            guess_ = words[cell - 1] + words[cell - kTileSize] - words[cell - kTileSize - 1];
    }

    int first() const { return 0; }
    void learn(std::uint32_t) {}
    std::uint32_t operator[](int) const { return guess_; }

  private:
    std::uint32_t guess_ = 0;
};

/// The same of amounts. Where there are a cell to the left and one above, paints mix on the line between
/// the two: how far along it the cell lies is learned of the channel in which they differ most.
template <int kChannels>
class AmountGuess {
  public:
    AmountGuess(const std::uint32_t* words, const std::int32_t* amount, int cell) {
        if (cell == 0) return;
        const int neighbour = neighbour_of(cell), above = cell - kTileSize;
        scale(words + neighbour * kChannels, growth(amount, cell, neighbour), guess_);
        if (above < 0 || above == neighbour) return;
        scale(words + above * kChannels, growth(amount, cell, above), way_);
        for (int k = 0; k < kChannels; ++k)
            way_[k] -= guess_[k];
        first_ = place_of_largest(way_);
    }

    int first() const { return first_; }
    void learn(std::uint32_t word) {
        if (way_[first_] == 0.0) return;
        const double share = std::clamp((number(word) - guess_[first_]) / way_[first_], -1.0, 1.0);
        for (int k = 0; k < kChannels; ++k)
            guess_[k] += share * way_[k];
    }
    std::uint32_t operator[](int channel) const { return rounded(guess_[channel]); }

  private:
    static void scale(const std::uint32_t* words, double factor, std::array<double, kChannels>& out) {
        for (int k = 0; k < kChannels; ++k)
            out[k] = number(words[k]) * factor;
    }

    std::array<double, kChannels> guess_{}, way_{};
    int first_ = 0;
};

/// The codes of a row of cells, channel by channel: planes are written and read by whole rows, since
/// their single bytes lie a page apart.
template <int kChannels>
using CodeRow = std::array<std::array<std::uint32_t, kTileSize>, kChannels>;

template <int kChannels>
void store_row(const CodeRow<kChannels>& codes, int row, std::byte* out) {
    for (int k = 0; k < kChannels; ++k)
        for (int byte = 0; byte < 4; ++byte) {
            std::byte* plane = out + (4 * k + byte) * kTileCells + row * kTileSize;
            for (int x = 0; x < kTileSize; ++x)
                plane[x] = static_cast<std::byte>(codes[k][x] >> (8 * byte));
        }
}

template <int kChannels>
void load_row(const std::byte* in, int row, CodeRow<kChannels>& codes) {
    for (int k = 0; k < kChannels; ++k) {
        const std::byte* planes = in + 4 * k * kTileCells + row * kTileSize;
        for (int x = 0; x < kTileSize; ++x) {
            std::uint32_t code = 0;
            for (int byte = 0; byte < 4; ++byte)
                code |= static_cast<std::uint32_t>(planes[byte * kTileCells + x]) << (8 * byte);
            codes[k][x] = code;
        }
    }
}

template <template <int> class Guess, int kChannels>
void encode(const std::uint32_t* words, const std::int32_t* amount, std::byte* out) {
    CodeRow<kChannels> codes;
    for (int cell = 0; cell < kTileCells; ++cell) {
        const int x = cell % kTileSize;
        Guess<kChannels> guess(words, amount, cell);
        const std::uint32_t* here = words + cell * kChannels;
        const int first = guess.first();
        const std::uint32_t first_code = folded(here[first] - guess[first]);
        guess.learn(here[first]);
        for (int k = 0; k < kChannels; ++k)
            codes[k][x] = folded(here[k] - guess[k]);
        codes[first][x] = first_code;
        if (x == kTileSize - 1) store_row<kChannels>(codes, cell / kTileSize, out);
    }
}

template <template <int> class Guess, int kChannels>
void decode(const std::byte* in, const std::int32_t* amount, std::uint32_t* words) {
    CodeRow<kChannels> codes;
    for (int cell = 0; cell < kTileCells; ++cell) {
        const int x = cell % kTileSize;
        if (x == 0) load_row<kChannels>(in, cell / kTileSize, codes);
        Guess<kChannels> guess(words, amount, cell);
        std::uint32_t* here = words + cell * kChannels;
        const int first = guess.first();
        const std::uint32_t first_word = guess[first] + unfolded(codes[first][x]);
        guess.learn(first_word);
        for (int k = 0; k < kChannels; ++k)
            here[k] = guess[k] + unfolded(codes[k][x]);
        here[first] = first_word;
    }
}

template <int kChannels>
void encode(const std::uint32_t* words, const Expectation& expected, std::byte* out) {
    if constexpr (kChannels == 1)
        if (expected.smooth) return encode<SmoothGuess, 1>(words, nullptr, out);
    if (expected.amount == nullptr)
        encode<PlainGuess, kChannels>(words, nullptr, out);
    else
        encode<AmountGuess, kChannels>(words, expected.amount, out);
}

template <int kChannels>
void decode(const std::byte* in, const Expectation& expected, std::uint32_t* words) {
    if constexpr (kChannels == 1)
        if (expected.smooth) return decode<SmoothGuess, 1>(in, nullptr, words);
    if (expected.amount == nullptr)
        decode<PlainGuess, kChannels>(in, nullptr, words);
    else
        decode<AmountGuess, kChannels>(in, expected.amount, words);
}

}  // namespace

void encode_tile(const std::uint32_t* words, int channels, const Expectation& expected, std::byte* out) {
    PASTOSO_CHECK(!expected.smooth || (channels == 1 && expected.amount == nullptr));
    switch (channels) {
        case 1:
            return encode<1>(words, expected, out);
        case 6:
            return encode<6>(words, expected, out);
        case 9:
            return encode<9>(words, expected, out);
        case 12:
            return encode<12>(words, expected, out);
        default:
            PASTOSO_CHECK_OP(channels, ==, 16);
            return encode<16>(words, expected, out);
    }
}

void decode_tile(const std::byte* in, int channels, const Expectation& expected, std::uint32_t* words) {
    PASTOSO_CHECK(!expected.smooth || (channels == 1 && expected.amount == nullptr));
    switch (channels) {
        case 1:
            return decode<1>(in, expected, words);
        case 6:
            return decode<6>(in, expected, words);
        case 9:
            return decode<9>(in, expected, words);
        case 12:
            return decode<12>(in, expected, words);
        default:
            PASTOSO_CHECK_OP(channels, ==, 16);
            return decode<16>(in, expected, words);
    }
}

}  // namespace pastoso::packing::PASTOSO_ISA
