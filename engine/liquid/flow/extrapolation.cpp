#include "liquid/flow/extrapolation.hpp"

#include "liquid/flow/velocity.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace pastoso::liquid {
namespace {

std::array<std::ptrdiff_t, 6> neighbour_steps(const grid::BoxShape& shape) {
    const std::ptrdiff_t y = shape.stride_y(), z = shape.stride_z();
    return {-1, 1, -y, y, -z, z};
}

/// How many bits are set.
constexpr std::array<float, 64> kCounts = [] {
    std::array<float, 64> counts{};
    for (std::uint32_t bits = 0; bits < counts.size(); ++bits)
        counts[bits] = static_cast<float>(std::popcount(bits));
    return counts;
}();

}  // namespace

Extrapolation::Extrapolation(const grid::BoxField& known, int rings) {
    std::vector<std::uint8_t> reached(known.values().size());
    std::ranges::transform(known.values(), reached.begin(), [](float value) { return value > 0.0F; });
    for (int ring = 0; ring < rings; ++ring)
        add_ring(known.shape(), reached);
}

void Extrapolation::add_ring(const grid::BoxShape& shape, std::vector<std::uint8_t>& known) {
    const auto steps = neighbour_steps(shape);
    const std::size_t begin = targets_.size();
    for (int k = -1; k <= shape.nz + 1; ++k)
        for (int j = -1; j <= shape.ny + 1; ++j)
            for (int i = -1; i <= shape.nx + 1; ++i) {
                const std::ptrdiff_t index = shape.index(i, j, k);
                if (known[static_cast<std::size_t>(index)] != 0) continue;
                std::uint32_t neighbours = 0;
                for (std::size_t n = 0; n < steps.size(); ++n)
                    if (known[static_cast<std::size_t>(index + steps[n])] != 0) neighbours |= 1U << n;
                if (neighbours != 0) targets_.push_back({static_cast<std::uint32_t>(index), neighbours});
            }
    for (std::size_t t = begin; t < targets_.size(); ++t)
        known[targets_[t].index] = 1;
    ring_ends_.push_back(targets_.size());
}

void Extrapolation::apply(grid::BoxField& field, core::ThreadPool& pool) const {
    constexpr std::size_t kBlock = 1024;
    std::size_t begin = 0;
    for (const std::size_t end : ring_ends_) {
        pool.run((end - begin + kBlock - 1) / kBlock, [&](std::size_t block, int) {
            fill(field, begin + block * kBlock, std::min(end, begin + (block + 1) * kBlock));
        });
        begin = end;
    }
}

void Extrapolation::fill(grid::BoxField& field, std::size_t begin, std::size_t end) const {
    const auto steps = neighbour_steps(field.shape());
    float* values = field.values().data();
    // Without branches, which would be foreseen half the time.
    const auto known = [](const Target& target, std::size_t bit, float value) {
        return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) &
                                    (0U - (target.neighbours >> bit & 1U)));
    };
    for (std::size_t t = begin; t < end; ++t) {
        const Target& target = targets_[t];
        const float* here = values + target.index;
        float sum = 0.0F;
        // In pairs, so that a mirrored field gives the mirrored sum.
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float before = known(target, 2 * axis, here[steps[2 * axis]]);
            const float behind = known(target, 2 * axis + 1, here[steps[2 * axis + 1]]);
            sum += before + behind;
        }
        values[target.index] = sum / kCounts[target.neighbours];
    }
}

}  // namespace pastoso::liquid
