// Values in a box of cubic cells. Cell (i, j, k) covers [i, i+1) x [j, j+1) x [k, k+1) in cell units,
// its centre lies at (i + 0.5, j + 0.5, k + 0.5); z points up. A field holds one float for each cell or
// for each face across one axis, x fastest, with kBoxGhosts samples around the box.
#pragma once

#include <cstddef>
#include <vector>

namespace pastoso::grid {

inline constexpr int kBoxGhosts = 2;

/// One shape serves cells and faces: there is room for nx + 1 samples along x, and so on. Rows are
/// padded to whole cache lines.
struct BoxShape {
    int nx = 0, ny = 0, nz = 0;  ///< cells, at least 1 each
    float cell_m = 0.0F;         ///< side of a cell, > 0

    std::ptrdiff_t stride_y() const { return (nx + 2 * kBoxGhosts + 1 + 15) / 16 * 16; }
    std::ptrdiff_t stride_z() const { return stride_y() * (ny + 2 * kBoxGhosts + 1); }
    std::size_t sample_count() const {
        return static_cast<std::size_t>(stride_z()) * static_cast<std::size_t>(nz + 2 * kBoxGhosts + 1);
    }
    /// Where sample (i, j, k) lies; -kBoxGhosts <= i <= nx + kBoxGhosts, and so on.
    std::ptrdiff_t index(int i, int j, int k) const {
        return i + kBoxGhosts + (j + kBoxGhosts) * stride_y() + (k + kBoxGhosts) * stride_z();
    }
    double cell_volume_m3() const {
        return static_cast<double>(cell_m) * static_cast<double>(cell_m) * static_cast<double>(cell_m);
    }
    friend bool operator==(const BoxShape&, const BoxShape&) = default;
};

class BoxField {
  public:
    BoxField() = default;
    explicit BoxField(const BoxShape& shape, float value = 0.0F)
        : shape_(shape), values_(shape.sample_count(), value) {}

    const BoxShape& shape() const { return shape_; }
    float& at(int i, int j, int k) { return values_[static_cast<std::size_t>(shape_.index(i, j, k))]; }
    float at(int i, int j, int k) const {
        return values_[static_cast<std::size_t>(shape_.index(i, j, k))];
    }
    float* row(int j, int k) { return values_.data() + shape_.index(0, j, k); }
    const float* row(int j, int k) const { return values_.data() + shape_.index(0, j, k); }

    /// All samples, ghosts among them.
    std::vector<float>& values() { return values_; }
    const std::vector<float>& values() const { return values_; }

    friend bool operator==(const BoxField&, const BoxField&) = default;

  private:
    BoxShape shape_;
    std::vector<float> values_;
};

}  // namespace pastoso::grid
