#include "trace/milk_medium.hpp"

#include "trace/numbers.hpp"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

namespace pastoso::trace {
namespace {

constexpr int kSide = grid::BlockField::kSide, kBlockCells = kSide * kSide * kSide;
constexpr float kSteps = 255.0F;
/// A shadow ray that has less left goes on by chance.
constexpr float kDark = 0.1F;

int cell_index(const glm::ivec3& within) {
    return within.x + kSide * (within.y + kSide * within.z);
}

}  // namespace

MilkMedium::MilkMedium(const grid::BlockField& fraction, float scattering_per_m)
    : blocks_(fraction.blocks()), scattering_per_m_(scattering_per_m) {
    if (fraction.empty()) return;
    const grid::BoxShape& shape = fraction.shape();
    shape_cells_ = {shape.nx, shape.ny, shape.nz};
    cell_m_ = shape.cell_m;
    per_cell_ = 1.0F / shape.cell_m;
    const auto count = static_cast<std::size_t>(blocks_.x) * blocks_.y * blocks_.z;
    bounds_.assign(count, Bounds{0.0F, 0.0F});
    slots_.assign(count, -1);
    for (int k = 0; k < blocks_.z; ++k)
        for (int j = 0; j < blocks_.y; ++j)
            for (int i = 0; i < blocks_.x; ++i)
                add_block(fraction, {i, j, k});
}

void MilkMedium::add_block(const grid::BlockField& fraction, const glm::ivec3& block) {
    const int at = index(block);
    const float* samples = fraction.block(at);
    if (samples == nullptr) return;
    const auto for_cells = [](const glm::ivec3& end, const auto& body) {
        for (int z = 0; z < end.z; ++z)
            for (int y = 0; y < end.y; ++y)
                for (int x = 0; x < end.x; ++x)
                    body(glm::ivec3(x, y, z));
    };
    const auto scattering = [&](const glm::ivec3& cell) {
        const float share = samples[grid::BlockField::sample(cell.x, cell.y, cell.z)];
        return std::clamp(share, 0.0F, 1.0F) * scattering_per_m_;
    };
    const glm::ivec3 left = shape_cells_ - kSide * block;
    float least = scattering_per_m_, most = 0.0F;
    for_cells(glm::min(left, glm::ivec3(kSide + 1)), [&](const glm::ivec3& cell) {
        least = std::min(least, scattering(cell));
        most = std::max(most, scattering(cell));
    });
    if (most <= 0.0F) return;
    bounds_[at] = {least, most};
    slots_[at] = static_cast<std::int32_t>(cells_.size());
    cells_.resize(cells_.size() + kBlockCells);
    std::uint8_t* cells = cells_.data() + slots_[at];
    const float steps = most > least ? kSteps / (most - least) : 0.0F;
    for_cells(glm::min(left, glm::ivec3(kSide)), [&](const glm::ivec3& cell) {
        cells[cell_index(cell)] = static_cast<std::uint8_t>((scattering(cell) - least) * steps + 0.5F);
    });
}

/// From block to block along a ray (Amanatides and Woo 1987); those at the border reach on beyond it.
struct MilkMedium::Walk {
    Walk(const MilkMedium& milk, const glm::vec3& origin_m, const glm::vec3& direction, float limit_m)
        : bounds(milk.bounds_.data()), last_m(limit_m) {
        const std::array<int, 3> strides = {1, milk.blocks_.x, milk.blocks_.x * milk.blocks_.y};
        const float block_m = milk.cell_m_ * kSide, per_block = milk.per_cell_ / kSide;
        for (int axis = 0; axis < 3; ++axis) {
            const float from_m = origin_m[axis] - 0.5F * milk.cell_m_;
            const int last = milk.blocks_[axis] - 1;
            const int block = std::clamp(static_cast<int>(from_m * per_block), 0, last);
            bounds += block * strides[axis];
            const bool up = direction[axis] > 0.0F;
            left[axis] = up ? last - block : block;
            stride[axis] = up ? strides[axis] : -strides[axis];
            step_m[axis] = exit_m[axis] = kFar;
            if (std::abs(direction[axis]) < 1e-9F) continue;
            const float way_per_m = 1.0F / direction[axis];
            step_m[axis] = block_m * std::abs(way_per_m);
            const float border_m = static_cast<float>(up ? block + 1 : block) * block_m;
            if (left[axis] > 0) exit_m[axis] = (border_m - from_m) * way_per_m;
            const float milk_ends_m =
                up ? milk.cell_m_ * static_cast<float>(milk.shape_cells_[axis] + 1) : -milk.cell_m_;
            last_m = std::min(last_m, (milk_ends_m - origin_m[axis]) * way_per_m);
        }
        find_end();
    }

    void find_end() {
        exit_axis = exit_m[0] < exit_m[1] ? 0 : 1;
        if (exit_m[2] < exit_m[exit_axis]) exit_axis = 2;
        end_m = std::min(exit_m[exit_axis], last_m);
    }

    /// False where there is no more milk.
    bool go_on() {
        if (!(end_m < last_m)) return false;
        at_m = std::max(at_m, end_m);
        bounds += stride[exit_axis];
        float& next_m = exit_m[exit_axis];
        next_m = --left[exit_axis] == 0 ? kFar : next_m + step_m[exit_axis];
        find_end();
        return true;
    }

    float left_m() const { return std::max(0.0F, end_m - at_m); }

    const Bounds* bounds;             ///< of the block it is in
    float at_m = 0.0F, end_m = 0.0F;  ///< along the ray, within the block
    float last_m;                     ///< where milk ends, or the ray
    int exit_axis = 0;                ///< across the face that the block is left by
    std::array<int, 3> left{}, stride{};
    std::array<float, 3> exit_m{}, step_m{};
};

/// The scattering of one of the cells around, by its share in the interpolation: linear in the milk as
/// all is that uses it, so that its mean alone counts.
float MilkMedium::scattering_near(const glm::vec3& point_m, Sampler& sampler) const {
    const glm::vec3 shift(sampler.next(), sampler.next(), sampler.next());
    const glm::uvec3 cell =
        glm::clamp(glm::ivec3(point_m * per_cell_ + shift - 0.5F), glm::ivec3(0), shape_cells_ - 1);
    constexpr unsigned side = kSide;
    const int at = index(cell / side);
    const std::int32_t slot = slots_[at];
    if (slot < 0) return 0.0F;
    const auto [least, most] = bounds_[at];
    const float step = (most - least) * (1.0F / kSteps);
    return least + step * static_cast<float>(cells_[slot + cell_index(cell % side)]);
}

float MilkMedium::free_path(const glm::vec3& origin_m, const glm::vec3& direction, float limit_m,
                            Sampler& sampler) const {
    Walk walk(*this, origin_m, direction, limit_m);
    // Optical depth up to the next event, spent block by block.
    float depth = -fast_log(1.0F - sampler.next());
    do {
        const auto [least, most] = *walk.bounds;
        while (depth < most * (walk.end_m - walk.at_m)) {
            walk.at_m += depth / most;
            const float scatters = sampler.next() * most;
            if (scatters < least ||
                scatters < scattering_near(origin_m + direction * walk.at_m, sampler))
                return std::min(walk.at_m, limit_m);
            depth = -fast_log(1.0F - sampler.next());
        }
        depth -= most * walk.left_m();
    } while (walk.go_on());
    return limit_m;
}

float MilkMedium::transmittance(const glm::vec3& origin_m, const glm::vec3& direction, float length_m,
                                Sampler& sampler) const {
    Walk walk(*this, origin_m, direction, length_m);
    float share = 1.0F;
    const auto ends_by_chance = [&] {
        if (share >= kDark) return false;
        const bool ends = sampler.next() * kDark >= share;
        share = kDark;
        return ends;
    };
    float depth = -fast_log(1.0F - sampler.next());
    do {
        const auto [least, most] = *walk.bounds;
        const float varies = most - least;
        share *= fast_exp(-least * walk.left_m());
        if (ends_by_chance()) return 0.0F;
        while (depth < varies * (walk.end_m - walk.at_m)) {
            walk.at_m += depth / varies;
            const float scatters = scattering_near(origin_m + direction * walk.at_m, sampler);
            share *= 1.0F - std::clamp((scatters - least) / varies, 0.0F, 1.0F);
            if (ends_by_chance()) return 0.0F;
            depth = -fast_log(1.0F - sampler.next());
        }
        depth -= varies * walk.left_m();
    } while (walk.go_on());
    return share;
}

}  // namespace pastoso::trace
