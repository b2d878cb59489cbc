#include "trace/dissolved.hpp"

#include "trace/numbers.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/common.hpp>

namespace pastoso::trace {
namespace {

constexpr int kBlockCells = 4;
constexpr int kMostShadowSamples = 48;
/// Shadows look at the milk once in so many cells.
constexpr float kShadowSpacingCells = 2.2F;

static_assert(grid::BlockField::kSide % kBlockCells == 0);

}  // namespace

DissolvedMilk::DissolvedMilk(grid::BlockField fraction, float scattering_per_m)
    : fraction_(std::move(fraction)), scattering_per_m_(scattering_per_m) {
    const grid::BoxShape& shape = fraction_.shape();
    if (fraction_.empty()) return;
    cells_ = {shape.nx, shape.ny, shape.nz};
    blocks_ = (cells_ + (kBlockCells - 1)) / kBlockCells;
    per_cell_ = 1.0F / shape.cell_m;
    block_m_ = shape.cell_m * kBlockCells;
    spacing_m_ = shape.cell_m * kShadowSpacingCells;
    for (float& value : fraction_.samples())
        value = std::clamp(value, 0.0F, 1.0F);
    bound_per_m_.assign(static_cast<std::size_t>(blocks_.x) * blocks_.y * blocks_.z, 0.0F);
    for (int k = 0; k < fraction_.blocks().z; ++k)
        for (int j = 0; j < fraction_.blocks().y; ++j)
            for (int i = 0; i < fraction_.blocks().x; ++i)
                note_bounds({i, j, k});
}

/// What the cells that a block keeps are to the bounds around them: a cell is felt up to the next cells'
/// middles.
void DissolvedMilk::note_bounds(const glm::ivec3& block) {
    using grid::BlockField;
    const float* samples = std::as_const(fraction_).block(fraction_.index(block));
    if (samples == nullptr) return;
    const glm::ivec3 first = block * BlockField::kSide;
    const glm::ivec3 count = glm::min(cells_ - first, glm::ivec3(BlockField::kSide));
    for (int z = 0; z < count.z; ++z)
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x) {
                const float scattering = samples[BlockField::sample(x, y, z)] * scattering_per_m_;
                if (scattering <= 0.0F) continue;
                const glm::ivec3 cell = first + glm::ivec3(x, y, z);
                const glm::ivec3 low = glm::max(cell - 1, glm::ivec3(0)) / kBlockCells;
                const glm::ivec3 high = glm::min(cell + 1, cells_ - 1) / kBlockCells;
                for (int c = low.z; c <= high.z; ++c)
                    for (int b = low.y; b <= high.y; ++b)
                        for (int a = low.x; a <= high.x; ++a) {
                            float& bound = bound_per_m_[a + blocks_.x * (b + blocks_.y * c)];
                            bound = std::max(bound, scattering);
                        }
            }
}

int DissolvedMilk::block_index(const glm::vec3& point_m) const {
    const glm::ivec3 block =
        glm::clamp(glm::ivec3(point_m * (per_cell_ / kBlockCells)), glm::ivec3(0), blocks_ - 1);
    return block.x + blocks_.x * (block.y + blocks_.y * block.z);
}

/// From block to block along a ray (Amanatides and Woo 1987); those at the border reach on beyond it.
struct DissolvedMilk::Walk {
    Walk(const DissolvedMilk& milk, const glm::vec3& origin, const glm::vec3& direction) {
        const std::array<int, 3> strides = {1, milk.blocks_.x, milk.blocks_.x * milk.blocks_.y};
        for (int axis = 0; axis < 3; ++axis) {
            const float place = origin[axis] / milk.block_m_;
            const int last = milk.blocks_[axis] - 1;
            const int block = std::clamp(static_cast<int>(place), 0, last);
            index += block * strides[axis];
            const bool up = direction[axis] > 0.0F;
            left[axis] = up ? last - block : block;
            stride[axis] = up ? strides[axis] : -strides[axis];
            const bool still = std::abs(direction[axis]) < 1e-9F;
            step_m[axis] = still ? kFar : milk.block_m_ / std::abs(direction[axis]);
            const float border = static_cast<float>(up ? block + 1 : block) * milk.block_m_;
            exit_m[axis] = still || left[axis] == 0 ? kFar : (border - origin[axis]) / direction[axis];
        }
    }

    int axis_of_exit() const {
        if (exit_m[0] < exit_m[1]) return exit_m[0] < exit_m[2] ? 0 : 2;
        return exit_m[1] < exit_m[2] ? 1 : 2;
    }

    void leave(int axis) {
        index += stride[axis];
        exit_m[axis] = --left[axis] == 0 ? kFar : exit_m[axis] + step_m[axis];
    }

    int index = 0;
    std::array<int, 3> left{}, stride{};
    std::array<float, 3> exit_m{}, step_m{};
};

/// How far it is along a ray to where milk ends.
float DissolvedMilk::way_out_m(const glm::vec3& origin_m, const glm::vec3& direction) const {
    const float cell_m = 1.0F / per_cell_;
    float way_m = kFar;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis]) < 1e-9F) continue;
        const float border_m =
            direction[axis] > 0.0F ? cell_m * static_cast<float>(cells_[axis] + 1) : -cell_m;
        way_m = std::min(way_m, (border_m - origin_m[axis]) / direction[axis]);
    }
    return way_m;
}

DissolvedMilk::FreePath DissolvedMilk::free_path(const glm::vec3& origin_m, const glm::vec3& direction,
                                                 float limit_m, Sampler& sampler) const {
    float milk_m = 0.0F;
    const float milk_ends_m = std::min(limit_m, way_out_m(origin_m, direction));
    Walk walk(*this, origin_m, direction);
    // Optical depth up to the next event, spent block by block.
    float depth = -fast_log(1.0F - sampler.next());
    for (float at = 0.0F;;) {
        const int axis = walk.axis_of_exit();
        const float end = std::min(walk.exit_m[axis], milk_ends_m);
        const float bound = bound_per_m_[walk.index];
        while (depth < bound * (end - at)) {
            at += depth / bound;
            const float share = fraction(origin_m + direction * at);
            milk_m += share / bound;
            if (sampler.next() * bound < share * scattering_per_m_)
                return {std::min(at, limit_m), milk_m};
            depth = -fast_log(1.0F - sampler.next());
        }
        if (!(end < milk_ends_m)) return {limit_m, milk_m};
        depth -= bound * std::max(0.0F, end - at);
        at = std::max(at, end);
        walk.leave(axis);
    }
}

float DissolvedMilk::transmittance(const glm::vec3& origin_m, const glm::vec3& direction, float length_m,
                                   Sampler& sampler) const {
    const int count = std::clamp(static_cast<int>(length_m / spacing_m_) + 1, 1, kMostShadowSamples);
    const float spacing = length_m / static_cast<float>(count), start = sampler.next();
    float sum = 0.0F;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 point = origin_m + direction * ((static_cast<float>(i) + start) * spacing);
        if (bound_per_m_[block_index(point)] > 0.0F) sum += fraction(point);
    }
    return fast_exp(-scattering_per_m_ * sum * spacing);
}

}  // namespace pastoso::trace
