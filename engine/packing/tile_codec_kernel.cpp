// Compiled once per instruction set; see pastoso_add_kernels.
#include "core/check.hpp"
#include "packing/amount_guess.hpp"
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

/// What a cell is expected to hold where its words are no amounts (amount_guess.hpp): the neighbour's
/// words.
template <int kChannels>
class PlainGuess {
  public:
    PlainGuess(const std::uint32_t* words, int cell)
        : known_(cell == 0 ? nullptr : words + neighbour_of(cell) * kChannels) {}

    std::uint32_t operator[](int channel) const { return known_ == nullptr ? 0U : known_[channel]; }

  private:
    const std::uint32_t* known_;
};

/// What a cell of a smooth surface is expected to hold: the median of the neighbours and of the plane
/// through them.
template <int kChannels>
class SmoothGuess {
  public:
    SmoothGuess(const std::uint32_t* words, int cell) {
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

    std::uint32_t operator[](int) const { return guess_; }

  private:
    std::uint32_t guess_ = 0;
};

/// The codes of a row of cells, channel by channel: planes are written and read by whole rows, since
/// their single bytes lie a page apart.
template <int kChannels>
using CodeRow = std::array<std::array<std::uint32_t, kTileSize>, kChannels>;

/// The same, cell by cell.
template <int kChannels>
using CellRow = std::array<std::array<std::uint32_t, kChannels>, kTileSize>;

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
void encode(const std::uint32_t* words, std::byte* out) {
    CodeRow<kChannels> codes;
    for (int cell = 0; cell < kTileCells; ++cell) {
        const int x = cell % kTileSize;
        const Guess<kChannels> guess(words, cell);
        for (int k = 0; k < kChannels; ++k)
            codes[k][x] = folded(words[cell * kChannels + k] - guess[k]);
        if (x == kTileSize - 1) store_row<kChannels>(codes, cell / kTileSize, out);
    }
}

template <template <int> class Guess, int kChannels>
void decode(const std::byte* in, std::uint32_t* words) {
    CodeRow<kChannels> codes;
    for (int cell = 0; cell < kTileCells; ++cell) {
        const int x = cell % kTileSize;
        if (x == 0) load_row<kChannels>(in, cell / kTileSize, codes);
        const Guess<kChannels> guess(words, cell);
        for (int k = 0; k < kChannels; ++k)
            words[cell * kChannels + k] = guess[k] + unfolded(codes[k][x]);
    }
}

template <int kChannels>
Cell<Words, kChannels> amount_codes(const std::uint32_t* words, const std::int32_t* amount, int cell) {
    const std::uint32_t* here = words + cell * kChannels;
    AmountGuess<kChannels> guess(words, amount, cell);
    const std::uint32_t first_word = here[guess.first()];
    const std::uint32_t first_code = folded(first_word - guess.first_word());
    guess.learn(first_word);
    Cell<Words, kChannels> codes = load<kChannels>(here);
    const Cell<Words, kChannels> guessed = guess.words();
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const Words difference = codes[i] - guessed[i];
        codes[i] = (difference << 1) ^ -(difference >> 31);
    }
    guess.put_first(first_code, codes);
    return codes;
}

template <int kChannels>
void encode_amounts(const std::uint32_t* words, const std::int32_t* amount, std::byte* out) {
    CellRow<kChannels> cells;
    CodeRow<kChannels> codes;
    for (int row = 0; row < kTileSize; ++row) {
        for (int x = 0; x < kTileSize; ++x)
            store<kChannels>(amount_codes<kChannels>(words, amount, row * kTileSize + x),
                             cells[x].data());
        for (int k = 0; k < kChannels; ++k)
            for (int x = 0; x < kTileSize; ++x)
                codes[k][x] = cells[x][k];
        store_row<kChannels>(codes, row, out);
    }
}

template <int kChannels>
void decode_amount(const std::uint32_t* codes, const std::int32_t* amount, int cell,
                   std::uint32_t* words) {
    AmountGuess<kChannels> guess(words, amount, cell);
    const std::uint32_t first_word = guess.first_word() + unfolded(codes[guess.first()]);
    guess.learn(first_word);
    const Cell<Words, kChannels> differences = load<kChannels>(codes);
    Cell<Words, kChannels> found = guess.words();
    for (std::size_t i = 0; i < found.size(); ++i)
        found[i] += (differences[i] >> 1) ^ -(differences[i] & 1);
    guess.put_first(first_word, found);
    store<kChannels>(found, words + cell * kChannels);
}

/// A cell has to wait for the words of its neighbours. Rows are decoded several together, each one cell
/// behind the row above, so that the processor has others to work on meanwhile.
template <int kChannels>
void decode_amounts(const std::byte* in, const std::int32_t* amount, std::uint32_t* words) {
    constexpr int kTogether = 4;
    CodeRow<kChannels> codes;
    std::array<CellRow<kChannels>, kTogether> rows;
    for (int top = 0; top < kTileSize; top += kTogether) {
        for (int row = 0; row < kTogether; ++row) {
            load_row<kChannels>(in, top + row, codes);
            for (int x = 0; x < kTileSize; ++x)
                for (int k = 0; k < kChannels; ++k)
                    rows[row][x][k] = codes[k][x];
        }
        for (int step = 0; step < kTileSize + kTogether - 1; ++step)
            for (int row = 0; row < kTogether; ++row) {
                const int x = step - row;
                if (x < 0 || x >= kTileSize) continue;
                decode_amount<kChannels>(rows[row][x].data(), amount, (top + row) * kTileSize + x,
                                         words);
            }
    }
}

template <int kChannels>
void encode(const std::uint32_t* words, const Expectation& expected, std::byte* out) {
    if constexpr (kChannels == 1)
        if (expected.smooth) return encode<SmoothGuess, 1>(words, out);
    if (expected.amount == nullptr)
        encode<PlainGuess, kChannels>(words, out);
    else
        encode_amounts<kChannels>(words, expected.amount, out);
}

template <int kChannels>
void decode(const std::byte* in, const Expectation& expected, std::uint32_t* words) {
    if constexpr (kChannels == 1)
        if (expected.smooth) return decode<SmoothGuess, 1>(in, words);
    if (expected.amount == nullptr)
        decode<PlainGuess, kChannels>(in, words);
    else
        decode_amounts<kChannels>(in, expected.amount, words);
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

PASTOSO_REGISTER_KERNELS(pastoso::packing, TileCodec, encode_tile, decode_tile)
