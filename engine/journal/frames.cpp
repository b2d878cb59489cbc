#include "journal/frames.hpp"

#include "core/check.hpp"
#include "core/hash.hpp"

#include <array>
#include <cstring>

namespace pastoso::journal {
namespace {

constexpr std::string_view kMark = "PJf1";
constexpr std::size_t kHeadBytes = 24, kSummedHeadBytes = 16;
/// Bounds the work that a file made of nothing but beginnings can ask for.
constexpr int kMostFalseBeginnings = 64;

std::uint64_t checksum(std::string_view head, std::string_view content) {
    core::Hash64 hash;
    hash.add(std::span(head.data(), kSummedHeadBytes));
    hash.add(std::span(content.data(), content.size()));
    return hash.value();
}

template <class Word>
Word word_at(std::string_view bytes, std::size_t place) {
    Word word{};
    std::memcpy(&word, bytes.data() + place, sizeof word);
    return word;
}

/// The frame that begins there, if it is whole.
std::optional<Frame> frame_at(std::string_view file, std::size_t offset) {
    const std::string_view rest = file.substr(offset);
    if (rest.size() < kHeadBytes || !rest.starts_with(kMark)) return std::nullopt;
    const auto size = word_at<std::uint32_t>(rest, 8);
    if (size > kMostFrameBytes || size > rest.size() - kHeadBytes) return std::nullopt;
    const std::string_view content = rest.substr(kHeadBytes, size);
    if (word_at<std::uint64_t>(rest, 16) != checksum(rest, content)) return std::nullopt;
    return Frame{static_cast<FrameKind>(word_at<std::uint32_t>(rest, 4)), offset, content};
}

}  // namespace

std::string framed(FrameKind kind, std::string_view content) {
    PASTOSO_CHECK_OP(content.size(), <=, kMostFrameBytes);
    const std::array<std::uint32_t, 3> words = {static_cast<std::uint32_t>(kind),
                                                static_cast<std::uint32_t>(content.size()), 0};
    std::string frame(kMark);
    frame.append(reinterpret_cast<const char*>(words.data()), sizeof words);
    const std::uint64_t sum = checksum(frame, content);
    frame.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    return frame.append(content);
}

Frames frames_of(std::span<const std::byte> bytes) {
    const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    Frames frames;
    std::optional<std::size_t> damage;
    int false_beginnings = 0;
    for (std::size_t at = 0; at < file.size();) {
        if (const auto frame = frame_at(file, at)) {
            if (damage && !frames.damaged_at) frames.damaged_at = damage;
            frames.whole.push_back(*frame);
            at += kHeadBytes + frame->content.size();
            continue;
        }
        if (!damage) damage = at;
        if (++false_beginnings > kMostFalseBeginnings) break;
        at = file.find(kMark, at + 1);
    }
    return frames;
}

}  // namespace pastoso::journal
