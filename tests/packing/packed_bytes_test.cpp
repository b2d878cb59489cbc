#include "packing/packed_bytes.hpp"

#include "core/error.hpp"

#include <string>

#include <gtest/gtest.h>

namespace pastoso::packing {
namespace {

TEST(PackedBytes, ComeBack) {
    for (const std::size_t size : {0U, 1U, 5000U, 3'000'000U}) {
        Bytes bytes(size);
        for (std::size_t i = 0; i < size; ++i)
            bytes[i] = static_cast<std::byte>(i * i >> 7);
        EXPECT_EQ(unpacked(packed(bytes), size), bytes);
    }
}

TEST(PackedBytes, AFrameOfAnotherLengthIsRefusedBeforeAnythingIsAllocated) {
    const Bytes bomb = packed(Bytes(std::size_t{1} << 28));
    EXPECT_LT(bomb.size(), 100'000U);
    EXPECT_THROW(unpacked(bomb, 1000), core::InputError);
    EXPECT_THROW(unpacked(bomb, (std::size_t{1} << 28) + 1), core::InputError);
}

TEST(PackedBytes, DamagedFramesAreRefused) {
    Bytes bytes(4000);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(i % 251 * (i % 17));
    const Bytes frame = packed(bytes);
    EXPECT_THROW(unpacked({}, 4000), core::InputError);
    for (std::size_t length = 0; length < frame.size(); length += 7)
        EXPECT_THROW(unpacked(std::span(frame).first(length), 4000), core::InputError) << length;
    constexpr std::size_t kHeaderBytes = 7;
    for (std::size_t at = kHeaderBytes; at < frame.size(); ++at) {
        Bytes flipped = frame;
        flipped[at] ^= std::byte{0x04};
        EXPECT_THROW(unpacked(flipped, 4000), core::InputError) << at;
    }
}

}  // namespace
}  // namespace pastoso::packing
