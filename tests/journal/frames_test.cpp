#include "journal/frames.hpp"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::journal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::string> contents(const std::string& file) {
    std::vector<std::string> contents;
    for (const Frame& frame : frames_of(std::as_bytes(std::span(file))).whole)
        contents.emplace_back(frame.content);
    return contents;
}

std::optional<std::size_t> damage(const std::string& file) {
    return frames_of(std::as_bytes(std::span(file))).damaged_at;
}

const std::string kFirst = framed(FrameKind::Header, "first"), kSecond = framed(FrameKind::Strokes, "");
const std::string kThird = framed(FrameKind::Saved, "PJf1, and the third");

TEST(Frames, ComeBackInOrder) {
    const std::string file = kFirst + kSecond + kThird;
    EXPECT_THAT(contents(file), ElementsAre("first", "", "PJf1, and the third"));
    const Frames frames = frames_of(std::as_bytes(std::span(file)));
    EXPECT_EQ(frames.whole[1].kind, FrameKind::Strokes);
    EXPECT_EQ(frames.whole[2].offset, kFirst.size() + kSecond.size());
    EXPECT_EQ(frames.damaged_at, std::nullopt);
}

TEST(Frames, ATornLastOneIsDropped) {
    for (std::size_t bytes = 0; bytes < kThird.size(); ++bytes) {
        const std::string file = kFirst + kThird.substr(0, bytes);
        EXPECT_THAT(contents(file), ElementsAre("first")) << bytes;
        EXPECT_EQ(damage(file), std::nullopt) << bytes;
    }
}

TEST(Frames, AnyChangedByteCostsItsFrameAlone) {
    for (std::size_t byte = 0; byte < kFirst.size(); ++byte) {
        std::string file = kSecond + kFirst + kThird;
        file[kSecond.size() + byte] ^= 0x10;
        EXPECT_THAT(contents(file), ElementsAre("", "PJf1, and the third")) << byte;
        EXPECT_EQ(damage(file), kSecond.size()) << byte;
    }
}

TEST(Frames, SizesBeyondTheFileOrAllReasonAreRefused) {
    for (const std::uint32_t size : {6U, 0x7fffffffU, 0xffffffffU}) {
        std::string file = kFirst;
        std::memcpy(file.data() + 8, &size, sizeof size);
        EXPECT_THAT(contents(file), IsEmpty());
    }
}

TEST(Frames, AFileOfNothingButBeginningsIsGivenUp) {
    std::string file = kFirst;
    for (int i = 0; i < 100; ++i)
        file += "PJf1";
    EXPECT_THAT(contents(file + kThird), SizeIs(1));
}

}  // namespace
}  // namespace pastoso::journal
