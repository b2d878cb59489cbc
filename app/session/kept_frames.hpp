// Moments of a liquid that are kept in memory to be looked at again.
#pragma once

#include "core/check.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace pastoso::session {

/// Every n-th step is kept, n = 1 at first. When they would take more memory than they may, every second
/// of them goes and n doubles: the whole time of the glass can always be sought, but ever more coarsely.
/// A `Packed` has a `step` and says how many bytes() it takes.
template <class Packed>
class KeptFrames {
  public:
    explicit KeptFrames(std::size_t budget_bytes) : budget_bytes_(budget_bytes) {}

    /// Of another glass.
    void clear() {
        frames_.clear();
        interval_ = 1;
    }

    /// Whether keep() would keep that step.
    bool wants(int step) const { return step % interval_ == 0; }

    /// Steps come in their order, the first one with 0.
    void keep(Packed frame) {
        PASTOSO_CHECK(frames_.empty() || frames_.back().step < frame.step);
        if (!wants(frame.step)) return;
        frames_.push_back(std::move(frame));
        // Two always stay, however little memory there is.
        while (bytes() > budget_bytes_ && frames_.size() > 2)
            thin_out();
    }

    /// The steps that are kept, the first one first.
    std::vector<int> steps() const {
        std::vector<int> steps;
        std::transform(frames_.begin(), frames_.end(), std::back_inserter(steps),
                       [](const Packed& frame) { return frame.step; });
        return steps;
    }

    /// The latest one at or before `step`; there is one.
    const Packed& at(int step) const {
        PASTOSO_CHECK(!frames_.empty());
        const auto after =
            std::upper_bound(frames_.begin(), frames_.end(), step,
                             [](int wanted, const Packed& frame) { return wanted < frame.step; });
        return after == frames_.begin() ? *after : *std::prev(after);
    }

    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const Packed& frame : frames_)
            sum += frame.bytes();
        return sum;
    }
    int interval() const { return interval_; }

    auto begin() const { return frames_.begin(); }
    auto end() const { return frames_.end(); }

  private:
    void thin_out() {
        interval_ *= 2;
        std::erase_if(frames_, [this](const Packed& frame) { return frame.step % interval_ != 0; });
    }

    std::size_t budget_bytes_;
    int interval_ = 1;
    std::vector<Packed> frames_;
};

}  // namespace pastoso::session
