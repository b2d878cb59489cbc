// Sums of light that photons leave in cells, from many threads at once and yet the same in any order: in
// whole numbers.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::trace {

class LightSums {
  public:
    explicit LightSums(std::size_t cells) : sums_(3 * cells) {}

    /// Any thread may; each channel from 0 to 1e3, to 2^-40. Up to 1e4 times as much fits in a cell.
    void add(std::size_t cell, const glm::vec3& light) {
        for (int channel = 0; channel < 3; ++channel) {
            const auto units = static_cast<std::uint64_t>(light[channel] * kUnits);
            std::atomic_ref(sums_[3 * cell + static_cast<std::size_t>(channel)])
                .fetch_add(units, std::memory_order_relaxed);
        }
    }

    std::size_t size() const { return sums_.size() / 3; }
    glm::vec3 at(std::size_t cell) const {
        glm::vec3 sum;
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] =
                static_cast<float>(sums_[3 * cell + static_cast<std::size_t>(channel)]) / kUnits;
        return sum;
    }

  private:
    static constexpr float kUnits = 1099511627776.0F;
    std::vector<std::uint64_t> sums_;
};

}  // namespace pastoso::trace
