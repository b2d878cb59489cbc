// Moves of the pen, nearly all that a recording holds, in a tenth of the memory that events take.
#pragma once

#include "brush/pen_sample.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pastoso::document {

struct TimedSample {
    std::int64_t tick = 0;
    brush::PenSample sample;
    friend bool operator==(const TimedSample&, const TimedSample&) = default;
};

/// Appended one by one and read back bit by bit as they were. The bits of each number, taken as an
/// integer, are told by their difference from the straight line through the two moves before,
/// 2 a[n-1] - a[n-2] modulo 2^64: nothing of what stays or goes on evenly, five or six bytes of a
/// coordinate. Copies share the blocks that are full, and no room is kept for more than a block.
class PackedMoves {
  public:
    /// Tick and sample as integers.
    static constexpr int kNumbers = 9;
    using Numbers = std::array<std::uint64_t, kNumbers>;

    void add(const TimedSample& move);

    std::size_t size() const { return size_; }
    /// Of the blocks.
    std::size_t bytes() const;

    /// Reads them from the first on; nothing may be added meanwhile.
    class Reader {
      public:
        explicit Reader(const PackedMoves& moves) : moves_(moves) {}
        /// There is one: not more calls than size().
        TimedSample next();

      private:
        const PackedMoves& moves_;
        std::size_t block_ = 0, place_ = 0;
        Numbers last_{}, before_{};
    };

  private:
    using Block = std::vector<std::byte>;  ///< of whole moves

    const Block& block(std::size_t index) const;

    std::vector<std::shared_ptr<const Block>> full_;
    Block open_;  ///< the last one
    std::size_t size_ = 0;
    Numbers last_{}, before_{};
};

}  // namespace pastoso::document
