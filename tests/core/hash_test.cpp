#include "core/hash.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace {

using pastoso::core::Hash64;

std::uint64_t hash_of(const std::vector<unsigned char>& bytes) {
    Hash64 hash;
    hash.add(std::span<const unsigned char>(bytes));
    return hash.value();
}

TEST(Hash64, OneByteIsOneStep) {
    // ((offset ^ 7) * prime), then the upper bits folded in once.
    std::uint64_t expected = (0xcbf29ce484222325ULL ^ 7U) * 0x100000001b3ULL;
    expected ^= expected >> 29;
    EXPECT_EQ(hash_of({7}), expected);
}

TEST(Hash64, EverySingleBitChangesIt) {
    const std::vector<unsigned char> zeros(19, 0);
    for (std::size_t bit = 0; bit < zeros.size() * 8; ++bit) {
        std::vector<unsigned char> changed = zeros;
        changed[bit / 8] ^= static_cast<unsigned char>(1U << (bit % 8));
        EXPECT_NE(hash_of(changed), hash_of(zeros)) << "bit " << bit;
    }
}

TEST(Hash64, OrderAndLengthMatter) {
    EXPECT_NE(hash_of({1, 2}), hash_of({2, 1}));
    EXPECT_NE(hash_of({0}), hash_of({0, 0}));
    EXPECT_NE(hash_of({}), hash_of({0}));
}

TEST(Hash64, IsWrittenInSixteenDigits) {
    EXPECT_EQ(Hash64().hex(), "cbf29ce484222325");
}

}  // namespace
