// A list that only grows and is cheap to copy.
#pragma once

#include "core/check.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace pastoso::core {

/// Values in the order in which they were added. Copies share the full blocks of kBlock values, which
/// nothing changes any more: a copy takes a pointer for each of these and the values after them.
template <class T, std::size_t kBlock = 256>
class SharedLog {
  public:
    void add(T value) {
        open_.push_back(std::move(value));
        if (open_.size() < kBlock) return;
        full_.push_back(std::make_shared<const std::vector<T>>(std::exchange(open_, {})));
    }

    std::size_t size() const { return full_.size() * kBlock + open_.size(); }

    const T& operator[](std::size_t index) const {
        PASTOSO_CHECK_OP(index, <, size());
        const std::size_t block = index / kBlock;
        return (block < full_.size() ? *full_[block] : open_)[index % kBlock];
    }

  private:
    std::vector<std::shared_ptr<const std::vector<T>>> full_;
    std::vector<T> open_;
};

}  // namespace pastoso::core
