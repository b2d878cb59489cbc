// Numbers at the points of a regular lattice, in metres, z up: what surfaces are made from.
#pragma once

#include "grid/box_field.hpp"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::liquid {

/// Point (i, j, k) lies at origin + spacing (i, j, k).
struct Lattice {
    int nx = 0, ny = 0, nz = 0;  ///< points, at least 1 each
    float spacing_m = 0.0F;      ///< > 0
    glm::vec3 origin_m{0.0F};

    glm::vec3 point_m(int i, int j, int k) const {
        return origin_m + spacing_m * glm::vec3(static_cast<float>(i), static_cast<float>(j),
                                                static_cast<float>(k));
    }
    friend bool operator==(const Lattice&, const Lattice&) = default;
};

/// The middles of a box of cells, each of whose sides is cut into `parts` (>= 1).
Lattice cell_centres(const grid::BoxShape& shape, int parts = 1);

/// Samples that lie in someone else's memory, x fastest.
struct SampleView {
    Lattice lattice;
    const float* values = nullptr;  ///< of point (0, 0, 0)
    std::ptrdiff_t stride_y = 0, stride_z = 0;

    const float* row(int j, int k) const { return values + j * stride_y + k * stride_z; }
    float at(int i, int j, int k) const { return row(j, k)[i]; }
};

/// Samples with memory of their own. Rows are padded by half a cache line, so that loops may work
/// on whole registers; what stands there means nothing.
class SampledField {
  public:
    SampledField() = default;
    explicit SampledField(const Lattice& lattice, float value = 0.0F);

    const Lattice& lattice() const { return lattice_; }
    std::ptrdiff_t stride_y() const { return stride_y_; }
    std::ptrdiff_t stride_z() const { return stride_y_ * lattice_.ny; }
    float* row(int j, int k) { return values_.data() + j * stride_y() + k * stride_z(); }
    const float* row(int j, int k) const { return values_.data() + j * stride_y() + k * stride_z(); }
    float at(int i, int j, int k) const { return row(j, k)[i]; }
    float& at(int i, int j, int k) { return row(j, k)[i]; }
    SampleView view() const { return {lattice_, values_.data(), stride_y(), stride_z()}; }

    /// Takes another shape and value, in the same memory where there is enough.
    void assign(const Lattice& lattice, float value = 0.0F);

  private:
    Lattice lattice_;
    std::ptrdiff_t stride_y_ = 0;
    std::vector<float> values_;
};

}  // namespace pastoso::liquid
