#include "trace/bvh.hpp"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace pastoso::trace {
namespace {

constexpr int kBins = 16;
/// Deeper down ranges are halved, which bounds the depth for any mesh (kBvhStack).
constexpr int kMostUnevenDepth = 24;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Box {
    glm::vec3 low{kInfinity}, high{-kInfinity};

    void add(const glm::vec3& point) { low = glm::min(low, point), high = glm::max(high, point); }
    void add(const Box& box) { low = glm::min(low, box.low), high = glm::max(high, box.high); }
    float half_area() const {
        const glm::vec3 d = high - low;
        return d.x < 0.0F ? 0.0F : d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

struct Item {
    Box box;
    glm::vec3 middle;
    std::uint32_t triangle;
};

/// Items [first, last) and what they span.
struct Range {
    std::size_t first = 0, last = 0;
    Box box, middles;

    std::size_t count() const { return last - first; }
};

struct Split {
    float cost = kInfinity;
    int axis = -1, bin = 0;
};

int bin_of(float middle, float low, float per_length) {
    return std::clamp(static_cast<int>((middle - low) * per_length), 0, kBins - 1);
}

}  // namespace

class BvhBuilder {
  public:
    BvhBuilder(const liquid::TriangleMesh& mesh, Bvh& bvh) : mesh_(mesh), bvh_(bvh) {
        items_.reserve(mesh.triangles.size());
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            Box box;
            for (const std::uint32_t corner : mesh.triangles[t])
                box.add(mesh.positions_m[corner]);
            items_.push_back({box, 0.5F * (box.low + box.high), t});
        }
        add_node(range_of(0, items_.size()), 0);
    }

  private:
    Range range_of(std::size_t first, std::size_t last) const {
        Range range{first, last, {}, {}};
        for (std::size_t i = first; i < last; ++i) {
            range.box.add(items_[i].box);
            range.middles.add(items_[i].middle);
        }
        return range;
    }

    Split best_split_along(int axis, const Range& range) const {
        const float low = range.middles.low[axis], length = range.middles.high[axis] - low;
        Split best;
        if (!(length > 0.0F)) return best;
        std::array<Box, kBins> boxes;
        std::array<std::size_t, kBins> counts{};
        for (std::size_t i = range.first; i < range.last; ++i) {
            const int bin = bin_of(items_[i].middle[axis], low, kBins / length);
            boxes[bin].add(items_[i].box);
            ++counts[bin];
        }
        std::array<float, kBins> above{};
        Box box;
        std::size_t count = 0;
        for (int bin = kBins - 1; bin > 0; --bin) {
            box.add(boxes[bin]);
            count += counts[bin];
            above[bin] = static_cast<float>(count) * box.half_area();
        }
        box = {};
        count = 0;
        for (int bin = 1; bin < kBins; ++bin) {
            box.add(boxes[bin - 1]);
            count += counts[bin - 1];
            const float cost = static_cast<float>(count) * box.half_area() + above[bin];
            if (count > 0 && count < range.count() && cost < best.cost) best = {cost, axis, bin};
        }
        return best;
    }

    /// Where the second part begins; in the middle when no plane parts the items.
    std::size_t part(const Range& range, int depth) {
        Split best;
        for (int axis = 0; axis < 3 && depth < kMostUnevenDepth; ++axis) {
            const Split split = best_split_along(axis, range);
            if (split.cost < best.cost) best = split;
        }
        if (best.axis < 0) return range.first + range.count() / 2;
        const float low = range.middles.low[best.axis];
        const float per_length = kBins / (range.middles.high[best.axis] - low);
        const auto begin = items_.begin();
        const auto second = std::stable_partition(
            begin + static_cast<std::ptrdiff_t>(range.first),
            begin + static_cast<std::ptrdiff_t>(range.last), [&](const Item& item) {
                return bin_of(item.middle[best.axis], low, per_length) < best.bin;
            });
        return static_cast<std::size_t>(second - begin);
    }

    /// Up to eight parts; the one with the largest surface is split next.
    std::vector<Range> children_of(const Range& range, int depth) {
        std::vector<Range> parts = {range};
        while (parts.size() < kBvhWidth) {
            int widest = -1;
            for (int i = 0; i < static_cast<int>(parts.size()); ++i)
                if (parts[i].count() > kBvhWidth &&
                    (widest < 0 || parts[i].box.half_area() > parts[widest].box.half_area()))
                    widest = i;
            if (widest < 0) break;
            const Range whole = parts[widest];
            const std::size_t second = part(whole, depth);
            parts[widest] = range_of(whole.first, second);
            parts.push_back(range_of(second, whole.last));
        }
        return parts;
    }

    std::uint32_t add_leaf(const Range& range) {
        BvhLeaf leaf{};
        std::fill_n(leaf.triangle, kBvhWidth, kNoTriangle);
        for (std::size_t i = range.first; i < range.last; ++i) {
            const std::size_t slot = i - range.first;
            leaf.triangle[slot] = items_[i].triangle;
            for (int corner = 0; corner < 3; ++corner) {
                const glm::vec3& position =
                    mesh_.positions_m[mesh_.triangles[items_[i].triangle][corner]];
                for (int axis = 0; axis < 3; ++axis)
                    leaf.corner[corner][axis][slot] = position[axis];
            }
        }
        bvh_.leaves_.push_back(leaf);
        return kBvhLeaf | static_cast<std::uint32_t>(bvh_.leaves_.size() - 1);
    }

    std::uint32_t add_node(const Range& range, int depth) {
        const auto place = static_cast<std::uint32_t>(bvh_.nodes_.size());
        bvh_.nodes_.emplace_back();
        BvhNode node{};
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(node.low[axis], kBvhWidth, kInfinity);
            std::fill_n(node.high[axis], kBvhWidth, -kInfinity);
        }
        const std::vector<Range> parts = children_of(range, depth);
        for (std::size_t c = 0; c < parts.size(); ++c) {
            for (int axis = 0; axis < 3; ++axis) {
                node.low[axis][c] = parts[c].box.low[axis];
                node.high[axis][c] = parts[c].box.high[axis];
            }
            node.child[c] =
                parts[c].count() <= kBvhWidth ? add_leaf(parts[c]) : add_node(parts[c], depth + 1);
        }
        bvh_.nodes_[place] = node;
        return place;
    }

    const liquid::TriangleMesh& mesh_;
    Bvh& bvh_;
    std::vector<Item> items_;
};

Bvh::Bvh(const liquid::TriangleMesh& mesh) {
    if (!mesh.empty()) BvhBuilder(mesh, *this);
}

}  // namespace pastoso::trace
