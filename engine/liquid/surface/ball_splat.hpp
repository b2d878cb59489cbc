// Adds balls that end to a lattice, layers on several threads.
#pragma once

#include "core/thread_pool.hpp"
#include "liquid/surface/ball_kernels.hpp"
#include "liquid/surface/sampled_field.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::liquid {

/// Slabs of layers, and which balls reach each of them, in ascending order: every sample gets its balls
/// in that order, whichever thread adds them.
class BallSplat {
  public:
    /// `balls` are finite. Adds to the values that are there.
    void add(const std::vector<Ball>& balls, AddBalls kernel, float least_square, SampledField& field,
             core::ThreadPool& pool);

  private:
    void sort(const std::vector<Ball>& balls, int nz);

    std::vector<std::uint32_t> starts_;  ///< of each slab's balls in `order_`, and the end
    std::vector<std::uint32_t> order_;
};

}  // namespace pastoso::liquid
