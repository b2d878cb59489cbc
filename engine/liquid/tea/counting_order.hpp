// Numbers of things by the group that each belongs to (counting sort): those of a group in their order.
#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace pastoso::liquid {

class CountingOrder {
  public:
    CountingOrder() = default;
    /// `group_of` each thing is below `groups`.
    template <class Thing, class GroupOf>
    CountingOrder(std::span<const Thing> things, std::size_t groups, const GroupOf& group_of)
        : begins_(groups + 1, 0), order_(things.size()) {
        for (const Thing& thing : things)
            ++begins_[group_of(thing) + 1];
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
        for (std::uint32_t i = 0; i < things.size(); ++i)
            order_[next[group_of(things[i])]++] = i;
    }

    std::size_t groups() const { return begins_.size() - 1; }
    std::span<const std::uint32_t> all() const { return order_; }
    std::span<const std::uint32_t> group(std::size_t index) const {
        return groups_between(index, index + 1);
    }
    /// Of the groups from begin to before end.
    std::span<const std::uint32_t> groups_between(std::size_t begin, std::size_t end) const {
        return all().subspan(begins_[begin], begins_[end] - begins_[begin]);
    }

  private:
    std::vector<std::size_t> begins_;  ///< of each group in the order, and its end
    std::vector<std::uint32_t> order_;
};

}  // namespace pastoso::liquid
