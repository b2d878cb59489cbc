// Moments in the order of time, of which only the last is whole: every other is told by what differs
// from the one after it.
#pragma once

#include "core/background_thread.hpp"
#include "document/moment.hpp"

#include <cstddef>
#include <deque>
#include <future>
#include <optional>
#include <vector>

namespace pastoso::document {

/// The uppermost differences stay as they are as long as they have at most `unpacked_bytes` together;
/// those below are packed, and stay unpacked beside it until limit_unpacked().
class MomentStack {
  public:
    explicit MomentStack(core::BackgroundThread& packer) : packer_(packer) {}

    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }

    void push(Moment moment);
    /// There is one. The next one below is made whole meanwhile.
    Moment pop();
    void clear();

    void set_unpacked_bytes(std::size_t bytes);

    /// Drops the lowest while the packed ones take more than this, or there are more than `most`
    /// moments. One that is not packed yet counts nothing: it is looked at again later.
    void drop_lowest(std::size_t packed_bytes, std::size_t most);
    /// Whether an answer of drop_lowest() may depend on what is not packed yet.
    bool is_undecided(std::size_t packed_bytes) const;

    /// Packs at once of those that wait for it, until they have at most so many bytes together.
    void limit_waiting(std::size_t bytes);

    /// Packs at once all that is to be packed.
    void finish_packing();

    /// What is packed takes; what is unpacked, whether packed as well or not, comes on top.
    std::size_t packed_bytes() const;
    std::size_t unpacked_bytes() const;
    /// Keeps of the packed ones only the upper as they are as well: as long as all unpacked ones have
    /// at most so many bytes.
    void limit_unpacked(std::size_t bytes);

    /// From the lowest on.
    std::vector<KeptStep> steps() const;

  private:
    void complete_top();
    void pack_below();
    std::size_t packed_count() const;

    core::BackgroundThread& packer_;
    std::size_t unpacked_bytes_ = 0;
    std::size_t size_ = 0;  ///< with the top
    std::deque<MomentDifference> below_;
    std::optional<Moment> top_;
    std::future<Moment> coming_top_;  ///< valid while the top is being made whole
    UndoStep coming_step_{};
};

}  // namespace pastoso::document
