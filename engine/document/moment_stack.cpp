#include "document/moment_stack.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::document {
namespace {

/// Zstandard adds at most its headers to tiles that are mere noise.
std::size_t most_packed_bytes(std::size_t bytes) {
    return bytes + bytes / 128;
}

}  // namespace

void MomentStack::push(Moment moment) {
    complete_top();
    if (top_) below_.emplace_back(*top_, moment);
    top_ = std::move(moment);
    ++size_;
    pack_below();
}

Moment MomentStack::pop() {
    PASTOSO_CHECK(!empty());
    complete_top();
    Moment moment = *std::move(top_);
    top_.reset();
    --size_;
    if (below_.empty()) return moment;
    MomentDifference next = std::move(below_.back());
    below_.pop_back();
    coming_step_ = next.step();
    if (!next.is_unpacked())
        coming_top_ =
            std::async(std::launch::async, [next = std::move(next), newer = moment, &packer = packer_] {
                const core::BackgroundThread::Hold hold(packer);
                return next.applied_to(newer);
            });
    else
        top_ = next.applied_to(moment);
    return moment;
}

void MomentStack::clear() {
    complete_top();
    below_.clear();
    top_.reset();
    size_ = 0;
}

void MomentStack::set_unpacked_bytes(std::size_t bytes) {
    unpacked_bytes_ = bytes;
    pack_below();
}

void MomentStack::complete_top() {
    if (coming_top_.valid()) top_ = coming_top_.get();
}

/// How many of the lowest are to be packed. Which these are does not depend on what is packed already.
std::size_t MomentStack::packed_count() const {
    std::size_t count = below_.size(), bytes = 0;
    while (count > 0 && (bytes += below_[count - 1].bytes()) <= unpacked_bytes_)
        --count;
    return count;
}

void MomentStack::pack_below() {
    for (std::size_t i = packed_count(); i-- > 0;)
        below_[i].pack_on(packer_);
}

void MomentStack::drop_lowest(std::size_t packed_bytes, std::size_t most) {
    std::size_t dropped = packed_count(), sum = 0;
    while (dropped > 0 && (sum += below_[dropped - 1].packed_bytes().value_or(0)) <= packed_bytes)
        --dropped;
    while (size_ - dropped > most && dropped < below_.size())
        ++dropped;
    below_.erase(below_.begin(), below_.begin() + static_cast<std::ptrdiff_t>(dropped));
    size_ -= dropped;
}

bool MomentStack::is_undecided(std::size_t packed_bytes) const {
    std::size_t sum = 0;
    bool all_packed = true;
    for (std::size_t i = packed_count(); i-- > 0;) {
        const auto packed = below_[i].packed_bytes();
        all_packed = all_packed && packed;
        sum += packed.value_or(most_packed_bytes(below_[i].bytes()));
    }
    return !all_packed && sum > packed_bytes;
}

/// The latest first: the packing thread is at the lowest.
void MomentStack::limit_waiting(std::size_t bytes) {
    const std::size_t count = packed_count();
    std::size_t waiting = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (!below_[i].packed_bytes()) waiting += below_[i].bytes();
    for (std::size_t i = count; i-- > 0 && waiting > bytes;) {
        if (below_[i].packed_bytes()) continue;
        waiting -= std::min(waiting, below_[i].bytes());
        below_[i].pack();
    }
}

void MomentStack::finish_packing() {
    for (std::size_t i = packed_count(); i-- > 0;)
        below_[i].pack();
}

std::size_t MomentStack::packed_bytes() const {
    std::size_t sum = 0;
    for (const MomentDifference& difference : below_)
        sum += difference.packed_bytes().value_or(0);
    return sum;
}

std::size_t MomentStack::unpacked_bytes() const {
    std::size_t sum = 0;
    for (const MomentDifference& difference : below_)
        if (difference.is_unpacked()) sum += difference.bytes();
    return sum;
}

void MomentStack::limit_unpacked(std::size_t bytes) {
    std::size_t sum = 0;
    for (std::size_t i = below_.size(); i-- > 0;)
        if (below_[i].is_unpacked() && (sum += below_[i].bytes()) > bytes) below_[i].drop_unpacked();
}

std::vector<KeptStep> MomentStack::steps() const {
    std::vector<KeptStep> steps;
    for (const MomentDifference& difference : below_) {
        const auto packed = difference.packed_bytes();
        steps.push_back({difference.step(), packed.value_or(difference.bytes()), packed.has_value()});
    }
    if (!empty()) steps.push_back({top_ ? top_->step : coming_step_, 0, false});
    return steps;
}

}  // namespace pastoso::document
