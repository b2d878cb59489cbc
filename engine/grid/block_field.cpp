#include "grid/block_field.hpp"

#include "core/check.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace pastoso::grid {
namespace {

glm::ivec3 cells_of(const BoxShape& shape) {
    return {shape.nx, shape.ny, shape.nz};
}

/// Calls visit(cell, sample) for what a block keeps of cells in the box.
template <class Visit>
void for_samples(const BoxShape& shape, const glm::ivec3& block, const Visit& visit) {
    const glm::ivec3 first = block * BlockField::kSide;
    const glm::ivec3 count = glm::min(cells_of(shape) - first, glm::ivec3(BlockField::kRow));
    for (int z = 0; z < count.z; ++z)
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x)
                visit(first + glm::ivec3(x, y, z), BlockField::sample(x, y, z));
}

template <class Visit>
void for_blocks(const glm::ivec3& blocks, int k0, int k1, const Visit& visit) {
    for (int k = k0; k < k1; ++k)
        for (int j = 0; j < blocks.y; ++j)
            for (int i = 0; i < blocks.x; ++i)
                visit(glm::ivec3(i, j, k));
}

std::vector<char> blocks_with_something(const BoxField& field) {
    std::vector<char> holds;
    const glm::ivec3 blocks = BlockField::block_counts(field.shape());
    for_blocks(blocks, 0, blocks.z, [&](const glm::ivec3& block) {
        bool any = false;
        for_samples(field.shape(), block, [&](const glm::ivec3& cell, int) {
            any = any || field.at(cell.x, cell.y, cell.z) != 0.0F;
        });
        holds.push_back(any ? 1 : 0);
    });
    return holds;
}

}  // namespace

BlockField::BlockField(const BoxShape& shape, const std::vector<char>& holds)
    : shape_(shape), blocks_(block_counts(shape)) {
    PASTOSO_CHECK_OP(holds.size(), ==, static_cast<std::size_t>(blocks_.x) * blocks_.y * blocks_.z);
    std::int32_t kept = 0;
    slots_.reserve(holds.size());
    for (const char any : holds)
        slots_.push_back(any != 0 ? kept++ : -1);
    samples_.assign(static_cast<std::size_t>(kept) * kSamples, 0.0F);
}

BlockField::BlockField(const BoxField& field) : BlockField(field.shape(), blocks_with_something(field)) {
    for_blocks(blocks_, 0, blocks_.z, [&](const glm::ivec3& at) {
        float* samples = block(index(at));
        if (samples == nullptr) return;
        for_samples(shape_, at, [&](const glm::ivec3& cell, int sample) {
            samples[sample] = field.at(cell.x, cell.y, cell.z);
        });
    });
}

const float* BlockField::block(int index) const {
    const std::int32_t slot = slots_[static_cast<std::size_t>(index)];
    return slot < 0 ? nullptr : samples_.data() + static_cast<std::size_t>(slot) * kSamples;
}

float* BlockField::block(int index) {
    const std::int32_t slot = slots_[static_cast<std::size_t>(index)];
    return slot < 0 ? nullptr : samples_.data() + static_cast<std::size_t>(slot) * kSamples;
}

float BlockField::at(int i, int j, int k) const {
    const glm::ivec3 cell(i, j, k), at = cell / kSide, within = cell - at * kSide;
    const float* samples = block(index(at));
    return samples == nullptr ? 0.0F : samples[sample(within.x, within.y, within.z)];
}

BoxField BlockField::dense() const {
    BoxField field(shape_);
    for_blocks(blocks_, 0, blocks_.z, [&](const glm::ivec3& at) {
        const float* samples = block(index(at));
        if (samples == nullptr) return;
        for_samples(shape_, at, [&](const glm::ivec3& cell, int sample) {
            field.at(cell.x, cell.y, cell.z) = samples[sample];
        });
    });
    return field;
}

void BlockField::copy_border(const glm::ivec3& block_at) {
    float* samples = block(index(block_at));
    if (samples == nullptr) return;
    for_samples(shape_, block_at, [&](const glm::ivec3& cell, int sample) {
        if (cell / kSide != block_at) samples[sample] = at(cell.x, cell.y, cell.z);
    });
}

void BlockField::copy_borders(int k0, int k1) {
    for_blocks(blocks_, k0, k1, [&](const glm::ivec3& at) { copy_border(at); });
}

float BlockField::between(const glm::vec3& place_cells) const {
    const glm::ivec3 last = cells_of(shape_) - 1;
    const glm::vec3 place = glm::clamp(place_cells - 0.5F, glm::vec3(0.0F), glm::vec3(last));
    const glm::ivec3 low = glm::min(glm::ivec3(place), glm::max(last - 1, glm::ivec3(0)));
    const glm::ivec3 at = low / kSide, within = low - at * kSide;
    const float* samples = block(index(at));
    if (samples == nullptr) return 0.0F;
    const float* v = samples + sample(within.x, within.y, within.z);
    const glm::vec3 share = place - glm::vec3(low);
    const auto mixed = [](float a, float b, float part) { return a + (b - a) * part; };
    const auto row = [&](const float* a) { return mixed(a[0], a[1], share.x); };
    const float lower = mixed(row(v), row(v + kRow), share.y);
    const float upper = mixed(row(v + kLayer), row(v + kLayer + kRow), share.y);
    return mixed(lower, upper, share.z);
}

}  // namespace pastoso::grid
