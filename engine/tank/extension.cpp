#include "tank/extension.hpp"

#include "core/check.hpp"

#include <bit>

namespace pastoso::tank {
namespace {

/// Orders as the numbers do.
std::uint32_t ordered(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

/// What a face takes from its neighbours along one axis: the mean of those that are closest to the
/// liquid.
struct Upwind {
    float phi, value;
};
Upwind closer(const Upwind& before, const Upwind& behind) {
    if (before.phi == behind.phi) return {before.phi, 0.5F * (before.value + behind.value)};
    return before.phi < behind.phi ? before : behind;
}

}  // namespace

VelocityExtension::VelocityExtension(const grid::BoxShape& shape) : shape_(shape) {
    for (Component& component : components_) {
        component.settled.resize(shape.sample_count(), kOutside);
        component.phi = grid::BoxField(shape);
    }
}

void VelocityExtension::extend(const grid::BoxField& phi, const liquid::VelocityField& known,
                               float reach_cells, liquid::VelocityField& velocity,
                               core::ThreadPool& pool) {
    PASTOSO_CHECK(phi.shape() == shape_);
    PASTOSO_CHECK(velocity.shape() == shape_);
    pool.run(3, [&](std::size_t n, int) {
        const int axis = static_cast<int>(n);
        Component& component = components_[n];
        const float reach_m = reach_cells * shape_.cell_m;
        compute_faces(component, axis, phi, known.along(axis), reach_m);
        sort(component);
        settle(component, velocity.along(axis));
        settle_left(component, velocity.along(axis));
        settle_rings(component, reach_m, velocity.along(axis));
    });
}

void VelocityExtension::compute_faces(Component& component, int axis, const grid::BoxField& phi,
                                      const grid::BoxField& known, float reach_m) const {
    const std::ptrdiff_t back = liquid::stride(shape_, axis);
    const auto [nx, ny, nz] = liquid::sample_counts(shape_, liquid::face_across(axis));
    // Less rounding: beyond its own reach phi is that reach.
    const float within_m = reach_m * 0.99999F;
    component.faces.clear();
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j) {
            const float *cells = phi.row(j, k), *is_known = known.row(j, k);
            float* face_phi = component.phi.row(j, k);
            std::uint8_t* settled = component.settled.data() + shape_.index(0, j, k);
            for (int i = 0; i < nx; ++i) {
                face_phi[i] = 0.5F * (cells[i - back] + cells[i]);
                settled[i] = is_known[i] > 0.0F ? kYes : kNo;
                if (settled[i] == kNo && face_phi[i] < within_m)
                    component.faces.push_back(
                        {ordered(face_phi[i]), static_cast<std::uint32_t>(shape_.index(i, j, k))});
            }
        }
}

void VelocityExtension::sort(Component& component) {
    // By eleven bits at a time, the lowest first; faces of one key stay in the order of their index.
    constexpr int kBits = 11;
    constexpr std::uint32_t kMask = (1U << kBits) - 1;
    component.sorted.resize(component.faces.size());
    for (int shift = 0; shift < 32; shift += kBits) {
        std::array<std::uint32_t, kMask + 2> begin{};
        for (const Face& face : component.faces)
            ++begin[(face.key >> shift & kMask) + 1];
        for (std::size_t n = 1; n < begin.size(); ++n)
            begin[n] += begin[n - 1];
        for (const Face& face : component.faces)
            component.sorted[begin[face.key >> shift & kMask]++] = face;
        component.faces.swap(component.sorted);
    }
}

void VelocityExtension::settle(Component& component, grid::BoxField& values) const {
    component.left.clear();
    float* value = values.values().data();
    const float* phi = component.phi.values().data();
    for (const Face& face : component.faces) {
        const std::ptrdiff_t here = face.index;
        const auto neighbour = [&](std::ptrdiff_t at) {
            const bool settled = component.settled[static_cast<std::size_t>(at)] == kYes;
            // One that is not settled counts as being no closer.
            return settled ? Upwind{phi[at], value[at]} : Upwind{phi[here], 0.0F};
        };
        float weights = 0.0F, sum = 0.0F;
        for (const int axis : liquid::kAxes) {
            const std::ptrdiff_t step = liquid::stride(shape_, axis);
            const Upwind from = closer(neighbour(here - step), neighbour(here + step));
            const float weight = phi[here] - from.phi;
            if (!(weight > 0.0F)) continue;
            weights += weight;
            sum += weight * from.value;
        }
        if (!(weights > 0.0F)) {
            component.left.push_back(face.index);
            continue;
        }
        value[here] = sum / weights;
        component.settled[static_cast<std::size_t>(here)] = kYes;
    }
}

void VelocityExtension::settle_left(Component& component, grid::BoxField& values) const {
    std::vector<std::uint32_t>& left = component.left;
    const auto beside_settled = [&](std::uint32_t index) {
        for (const int axis : liquid::kAxes)
            for (const int side : {-1, 1})
                if (component.settled[static_cast<std::size_t>(
                        index + side * liquid::stride(shape_, axis))] == kYes)
                    return true;
        return false;
    };
    do {
        component.ring.clear();
        std::erase_if(left, [&](std::uint32_t index) {
            if (!beside_settled(index)) return false;
            component.ring.push_back(index);
            return true;
        });
        settle_by_means(component, values);
    } while (!component.ring.empty());
}

void VelocityExtension::settle_rings(Component& component, float reach_m, grid::BoxField& values) const {
    const float* phi = component.phi.values().data();
    const auto add_neighbours = [&](std::uint32_t index) {
        for (const int axis : liquid::kAxes)
            for (const int side : {-1, 1}) {
                const auto at = static_cast<std::uint32_t>(index + side * liquid::stride(shape_, axis));
                if (component.settled[at] != kNo) continue;
                component.settled[at] = kInRing;
                component.ring.push_back(at);
            }
    };
    component.ring.clear();
    for (const Face& face : component.faces)
        if (component.settled[face.index] == kYes && phi[face.index] > reach_m - 2.0F * shape_.cell_m)
            add_neighbours(face.index);
    settle_by_means(component, values);
    for (int ring = 1; ring < kMeanRings; ++ring) {
        component.left.swap(component.ring);
        component.ring.clear();
        for (const std::uint32_t index : component.left)
            add_neighbours(index);
        settle_by_means(component, values);
    }
}

void VelocityExtension::settle_by_means(Component& component, grid::BoxField& values) const {
    float* value = values.values().data();
    for (const std::uint32_t index : component.ring) {
        float sum = 0.0F, count = 0.0F;
        for (const int axis : liquid::kAxes) {
            const std::ptrdiff_t step = liquid::stride(shape_, axis), before = index - step,
                                 behind = index + step;
            const bool has_before = component.settled[static_cast<std::size_t>(before)] == kYes,
                       has_behind = component.settled[static_cast<std::size_t>(behind)] == kYes;
            // In pairs, so that a mirrored field gives the mirrored sum.
            sum += (has_before ? value[before] : 0.0F) + (has_behind ? value[behind] : 0.0F);
            count += (has_before ? 1.0F : 0.0F) + (has_behind ? 1.0F : 0.0F);
        }
        value[index] = sum / count;
    }
    for (const std::uint32_t index : component.ring)
        component.settled[index] = kYes;
}

}  // namespace pastoso::tank
