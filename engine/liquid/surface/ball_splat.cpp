#include "liquid/surface/ball_splat.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pastoso::liquid {
namespace {

constexpr int kSlabLayers = 4;

int slab_count(int nz) {
    return (nz + kSlabLayers - 1) / kSlabLayers;
}

/// Slabs [first, end) that a ball may reach.
struct Slabs {
    int first, end;
};
Slabs slabs_of(const Ball& ball, int nz) {
    const float low = std::ceil(ball.z - ball.reach), high = std::floor(ball.z + ball.reach);
    if (!(high >= 0.0F) || !(low <= static_cast<float>(nz - 1))) return {0, 0};
    const float last = static_cast<float>(nz - 1);
    return {static_cast<int>(std::max(low, 0.0F)) / kSlabLayers,
            static_cast<int>(std::min(high, last)) / kSlabLayers + 1};
}

}  // namespace

void BallSplat::sort(const std::vector<Ball>& balls, int nz) {
    const auto slabs = static_cast<std::size_t>(slab_count(nz));
    starts_.assign(slabs + 2, 0);
    const auto for_each_place = [&](const auto& use) {
        for (std::uint32_t n = 0; n < balls.size(); ++n) {
            const Slabs reached = slabs_of(balls[n], nz);
            for (int slab = reached.first; slab < reached.end; ++slab)
                use(static_cast<std::size_t>(slab), n);
        }
    };
    // Counted two places on, so that filling moves each start to where it belongs.
    for_each_place([&](std::size_t slab, std::uint32_t) { ++starts_[slab + 2]; });
    for (std::size_t slab = 2; slab < starts_.size(); ++slab)
        starts_[slab] += starts_[slab - 1];
    order_.resize(starts_.back());
    for_each_place([&](std::size_t slab, std::uint32_t n) { order_[starts_[slab + 1]++] = n; });
}

void BallSplat::add(const std::vector<Ball>& balls, AddBalls kernel, float least_square,
                    SampledField& field, core::ThreadPool& pool) {
    const Lattice& lattice = field.lattice();
    sort(balls, lattice.nz);
    pool.run(static_cast<std::size_t>(slab_count(lattice.nz)), [&](std::size_t slab, int) {
        const int first = static_cast<int>(slab) * kSlabLayers;
        const BallSlab layers{field.row(0, 0),
                              field.stride_y(),
                              field.stride_z(),
                              lattice.nx,
                              lattice.ny,
                              first,
                              std::min(first + kSlabLayers, lattice.nz),
                              least_square};
        const std::uint32_t begin = starts_[slab];
        kernel(layers, balls.data(), order_.data() + begin, starts_[slab + 1] - begin);
    });
}

}  // namespace pastoso::liquid
