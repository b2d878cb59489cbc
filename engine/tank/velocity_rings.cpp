#include "tank/velocity_rings.hpp"

#include "liquid/flow/slices.hpp"
#include "liquid/flow/walls.hpp"

#include <algorithm>

namespace pastoso::tank {

using liquid::RowRange;

VelocityRings::VelocityRings(const grid::BoxShape& shape) : shape_(shape), used_(shape) {
    for (Component& component : components_) {
        component.known.assign(shape.sample_count(), 0);
        component.targets.resize(static_cast<std::size_t>(shape.nz) + 1);
    }
}

void VelocityRings::extend(const liquid::VelocityField& known, const liquid::RowRanges& samples,
                           int rings, liquid::VelocityField& velocity, core::ThreadPool& pool) {
    const auto for_components = [&](const auto& body) {
        liquid::for_slices(pool, 0, shape_.nz + 1, [&](int k) {
            for (const int axis : liquid::kAxes)
                body(axis, k, components_[static_cast<std::size_t>(axis)]);
        });
    };
    for_components(
        [&](int axis, int k, Component& component) { load(known.along(axis), samples, k, component); });
    used_ = samples;
    for (int ring = 0; ring < rings; ++ring) {
        for_components([&](int axis, int k, Component& component) {
            compute_targets(velocity.along(axis), samples, k, component);
        });
        for_components([&](int axis, int k, Component& component) {
            apply(velocity.along(axis), k, component);
            if (ring == 0) add_flying(known.along(axis), k, component);
        });
    }
}

void VelocityRings::load(const grid::BoxField& known, const liquid::RowRanges& samples, int k,
                         Component& component) const {
    for (int j = 0; j <= shape_.ny; ++j) {
        std::uint8_t* mask = component.known.data() + shape_.index(0, j, k);
        const RowRange before = used_.at(j, k), row = samples.at(j, k);
        std::fill(mask + before.begin, mask + std::max(before.begin, before.end), 0);
        const float* is_known = known.row(j, k);
        for (int i = row.begin; i < row.end; ++i)
            mask[i] = is_known[i] == kLiquidFace ? 1 : 0;
    }
}

void VelocityRings::add_flying(const grid::BoxField& known, int k, Component& component) const {
    for (int j = 0; j <= shape_.ny; ++j) {
        const RowRange row = used_.at(j, k);
        std::uint8_t* mask = component.known.data() + shape_.index(0, j, k);
        const float* is_known = known.row(j, k);
        for (int i = row.begin; i < row.end; ++i)
            if (is_known[i] == kFlyingFace) mask[i] = 1;
    }
}

void VelocityRings::compute_targets(const grid::BoxField& field, const liquid::RowRanges& samples, int k,
                                    Component& component) const {
    auto& targets = component.targets[static_cast<std::size_t>(k)];
    targets.clear();
    const std::ptrdiff_t y = shape_.stride_y(), z = shape_.stride_z();
    std::array<std::uint8_t, liquid::kMaxBoxSide_cells + 1> wanted;
    for (int j = 0; j <= shape_.ny; ++j) {
        const RowRange row = samples.at(j, k);
        if (row.empty()) continue;
        const std::ptrdiff_t first = shape_.index(0, j, k);
        const std::uint8_t* known = component.known.data() + first;
        for (int i = row.begin; i < row.end; ++i)
            wanted[static_cast<std::size_t>(i)] =
                static_cast<std::uint8_t>((known[i - 1] | known[i + 1] | known[i - y] | known[i + y] |
                                           known[i - z] | known[i + z]) &
                                          (known[i] ^ 1));
        for (int i = row.begin; i < row.end; ++i) {
            if (wanted[static_cast<std::size_t>(i)] == 0) continue;
            const float* value = field.row(j, k) + i;
            const std::uint8_t* mask = known + i;
            const auto pair = [&](std::ptrdiff_t step) {
                return (mask[-step] != 0 ? value[-step] : 0.0F) + (mask[step] != 0 ? value[step] : 0.0F);
            };
            const int count = mask[-1] + mask[1] + mask[-y] + mask[y] + mask[-z] + mask[z];
            targets.push_back({first + i, ((pair(1) + pair(y)) + pair(z)) / static_cast<float>(count)});
        }
    }
}

void VelocityRings::apply(grid::BoxField& field, int k, Component& component) {
    for (const Target& target : component.targets[static_cast<std::size_t>(k)]) {
        field.values()[static_cast<std::size_t>(target.index)] = target.value;
        component.known[static_cast<std::size_t>(target.index)] = 1;
    }
}

}  // namespace pastoso::tank
