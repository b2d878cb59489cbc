#include "packing/tile_codec.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::packing {
namespace {

using grid::kTileCells;

constexpr Expectation kSmooth{.amount = nullptr, .smooth = true};

std::vector<std::uint32_t> random_words(int count, std::uint32_t seed, std::uint32_t mask) {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        words[i] = core::scramble(core::scramble(static_cast<std::uint32_t>(i)) + seed) & mask;
    return words;
}

std::vector<std::byte> encoded(const std::vector<std::uint32_t>& words, int channels,
                               const Expectation& expected) {
    std::vector<std::byte> bytes(tile_bytes(channels));
    core::kernels<TileCodec>(core::Isa::Baseline).encode(words.data(), channels, expected, bytes.data());
    return bytes;
}

TEST(TileCodec, AnyWordsComeBack) {
    for (const int channels : {1, 6, 9, 12, 16}) {
        for (const std::uint32_t mask : {0xffffffffU, 0x7fffffffU, 0xffU, 0U}) {
            const auto words = random_words(channels * kTileCells, 7, mask);
            const auto random = random_words(kTileCells, 8, mask);
            std::vector<std::int32_t> amount(kTileCells);
            std::memcpy(amount.data(), random.data(), tile_bytes(1));
            for (const Expectation& with : {Expectation{}, Expectation{amount.data()}, kSmooth}) {
                if (with.smooth && channels > 1) continue;
                std::vector<std::uint32_t> back(words.size());
                core::kernels<TileCodec>().decode(encoded(words, channels, with).data(), channels, with,
                                                  back.data());
                EXPECT_EQ(back, words) << channels << " channels, mask " << mask;
            }
        }
    }
}

TEST(TileCodec, AnyBytesGiveSomeWordsThatEncodeToThem) {
    const auto random = random_words(16 * kTileCells, 3, 0xffffffffU);
    std::vector<std::byte> bytes(tile_bytes(16));
    std::memcpy(bytes.data(), random.data(), bytes.size());
    std::vector<std::uint32_t> words(random.size());
    core::kernels<TileCodec>().decode(bytes.data(), 16, {}, words.data());
    EXPECT_EQ(encoded(words, 16, {}), bytes);
}

TEST(TileCodec, AllInstructionSetsGiveTheSameBytesAndWords) {
    for (const int channels : {1, 6, 9, 12, 16}) {
        // Amounts that are mostly alike lie on the line between their neighbours, others far from it.
        auto words = random_words(channels * kTileCells, 5, 0x00ffffffU);
        for (std::size_t i = words.size() / 2; i < words.size(); ++i)
            words[i] = (words[i] & 0xffU) + 1000 * static_cast<std::uint32_t>(i % channels);
        const auto random = random_words(kTileCells, 6, 0x0fffffffU);
        std::vector<std::int32_t> amount(random.begin(), random.end());
        std::fill_n(amount.begin(), 200, 0);
        const auto bytes = encoded(words, channels, {amount.data()});
        for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
            if (isa > core::best_isa()) continue;
            std::vector<std::byte> same(bytes.size());
            core::kernels<TileCodec>(isa).encode(words.data(), channels, {amount.data()}, same.data());
            EXPECT_EQ(same, bytes) << channels;
            std::vector<std::uint32_t> back(words.size());
            core::kernels<TileCodec>(isa).decode(bytes.data(), channels, {amount.data()}, back.data());
            EXPECT_EQ(back, words) << channels;
        }
    }
}

TEST(TileCodec, TheFirstBytesAreThoseOfTheFormat) {
    // Row 0 is 5, 4, 4, 4 ...; folded differences: 10 (of 5 from 0), 1 (of -1), 0, 0 ...
    std::vector<std::uint32_t> words(kTileCells, 4);
    words[0] = 5;
    const auto bytes = encoded(words, 1, {});
    EXPECT_EQ(bytes[0], std::byte{10});
    EXPECT_EQ(bytes[1], std::byte{1});
    EXPECT_EQ(bytes[2], std::byte{0});
    // The first cell of the next row is expected to be 5, as the one above.
    EXPECT_EQ(bytes[64], std::byte{1});
    EXPECT_EQ(std::count(bytes.begin(), bytes.end(), std::byte{0}), 4 * kTileCells - 3);
}

TEST(TileCodec, ASlopeIsSmoothAndAStepStaysOne) {
    std::vector<std::uint32_t> words(kTileCells);
    for (int cell = 0; cell < kTileCells; ++cell) {
        const int x = cell % grid::kTileSize, y = cell / grid::kTileSize;
        words[cell] = static_cast<std::uint32_t>(1000 * x - 300 * y + (x < 20 ? 0 : 7));
    }
    const auto bytes = encoded(words, 1, kSmooth);
    for (int cell = grid::kTileSize + 1; cell < kTileCells; ++cell)
        ASSERT_TRUE(cell % grid::kTileSize == 0 || bytes[cell] == std::byte{0}) << cell;
}

TEST(TileCodec, PaintOfOneKindIsNearlyNothingButItsThickness) {
    std::vector<std::int32_t> amount(kTileCells);
    std::vector<std::uint32_t> words(16 * kTileCells);
    for (int cell = 0; cell < kTileCells; ++cell) {
        amount[cell] = static_cast<std::int32_t>(5'000'000 + core::scramble(cell) % 1'000'000);
        for (int k = 0; k < 16; ++k)
            words[16 * cell + k] = static_cast<std::uint32_t>(amount[cell] * 0.01 * k);
    }
    const auto bytes = encoded(words, 16, {amount.data()});
    for (int k = 0; k < 16; ++k)
        for (int cell = 1; cell < kTileCells; ++cell) {
            const std::size_t at = 4 * k * kTileCells + cell;
            // Rounded down here, there, and in between: two off at most, folded to at most 4.
            ASSERT_LE(std::to_integer<int>(bytes[at]), 4);
            ASSERT_EQ(bytes[at + kTileCells], std::byte{0});
        }
}

}  // namespace
}  // namespace pastoso::packing
