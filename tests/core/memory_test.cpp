#include "core/memory.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

TEST(Memory, TheMachineTellsWhatIsLeft) {
    EXPECT_GT(available_memory_bytes(), std::size_t{16} << 20);
    EXPECT_LT(available_memory_bytes(), SIZE_MAX);
}

TEST(Memory, WhatIsWrittenIsResident) {
    constexpr std::size_t kSize = std::size_t{64} << 20;
    const std::size_t before = resident_memory_bytes();
    const std::vector<char> much(kSize, 1);
    EXPECT_GT(resident_memory_bytes(), before + kSize * 9 / 10);
    EXPECT_GE(peak_memory_bytes(), before + kSize * 9 / 10);
    EXPECT_EQ(much.back(), 1);
}

}  // namespace
}  // namespace pastoso::core
