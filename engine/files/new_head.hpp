// Another beginning for a file that a format library is writing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace pastoso::files {

/// Takes bytes for a place in a file, in bytes from its beginning.
using ByteSink = std::function<void(std::uint64_t place, std::span<const std::byte> bytes)>;

/// Holds the first `head_bytes` back until all of them are there, puts make(head) in their place and moves
/// everything behind them on. The head must come first, in the order of its bytes.
class NewHead {
  public:
    NewHead(std::size_t head_bytes, std::function<std::string(std::string_view head)> make, ByteSink next);

    void write_at(std::uint64_t place, std::span<const std::byte> bytes);

  private:
    std::size_t take_head(std::uint64_t place, std::span<const std::byte> bytes);

    std::size_t head_bytes_;
    std::function<std::string(std::string_view)> make_;
    ByteSink next_;
    std::string head_;
    std::uint64_t new_bytes_ = 0;
};

}  // namespace pastoso::files
