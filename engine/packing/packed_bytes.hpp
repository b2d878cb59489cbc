// Bytes compressed by Zstandard, with a checksum of what they were.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pastoso::packing {

using Bytes = std::vector<std::byte>;

/// Makes Zstandard frames (RFC 8878) with the content's size and checksum, one after the other in the
/// same memory. The same bytes give the same frame. For one thread at a time.
class Packer {
  public:
    Packer();
    ~Packer();
    Packer(const Packer&) = delete;
    Packer& operator=(const Packer&) = delete;

    Bytes packed(std::span<const std::byte> bytes);

  private:
    struct Context;
    std::unique_ptr<Context> context_;
    Bytes room_;
};

/// Reads frames one after the other in the same memory. For one thread at a time.
class Unpacker {
  public:
    Unpacker();
    ~Unpacker();
    Unpacker(const Unpacker&) = delete;
    Unpacker& operator=(const Unpacker&) = delete;

    /// The frame's content, which must be `size` bytes long: no more is ever allocated. It stands until
    /// the next call. Throws InputError with a sentence that names no place when the frame is damaged or
    /// holds more or less.
    std::span<const std::byte> unpacked(std::span<const std::byte> frame, std::size_t size);

  private:
    struct Context;
    std::unique_ptr<Context> context_;
    Bytes room_;
};

/// A single frame.
Bytes packed(std::span<const std::byte> bytes);

/// The content of a single frame, as Unpacker gives it.
Bytes unpacked(std::span<const std::byte> frame, std::size_t size);

/// The most that a frame of so many bytes takes.
std::size_t most_packed_bytes(std::size_t size);

std::span<const std::byte> bytes_of(const std::string& text);

}  // namespace pastoso::packing
