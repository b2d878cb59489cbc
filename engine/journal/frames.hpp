// A file of pieces that are appended one by one, each with its size and its checksum, so that a reader
// knows which of them are whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::journal {

enum class FrameKind : std::uint32_t { Header = 1, Strokes = 2, Checkpoint = 3, Saved = 4 };

/// Content of a frame at most: the largest picture that can be painted, as text, has 5.4 bytes a pixel.
inline constexpr std::size_t kMostFrameBytes = std::size_t{640} << 20;

struct Frame {
    FrameKind kind{};
    std::size_t offset = 0;  ///< in the file
    std::string_view content;
};

/// The bytes of a frame: "PJf1", kind, size of the content, 0, checksum (core/hash.hpp of the first
/// sixteen bytes and the content), content. All little-endian. The content is not longer than
/// kMostFrameBytes.
std::string framed(FrameKind kind, std::string_view content);

struct Frames {
    std::vector<Frame> whole;  ///< in the order of the file, whose bytes outlive them
    /// Where bytes that are no whole frame stand before one that is; the end of the file, where the last
    /// frame may have been torn off, does not count.
    std::optional<std::size_t> damaged_at;
};

/// Looks for the next whole frame after what is none; gives up after a few dozen false beginnings.
Frames frames_of(std::span<const std::byte> file);

}  // namespace pastoso::journal
