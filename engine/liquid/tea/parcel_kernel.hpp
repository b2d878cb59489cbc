// A parcel's kernel on a lattice: how its milk is shared among the cells around it.
#pragma once

#include "liquid/flow/row_ranges.hpp"
#include "liquid/tea/parcel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/exponential.hpp>
#include <glm/vec3.hpp>

namespace pastoso::liquid {

/// Lengths in cells of a lattice whose first cell's middle lies at 0.
///     K(d) = (1 - d^T M^-1 d)^2 where it is not beyond 1,  M = reach^2 S + b^2,
/// S the parcel's shape, b what a lattice needs to show it: b^2 is at least 1/2, and so much that a
/// parcel as it was poured reaches 1.5. M^-1 is taken apart (L D L^T): each row of cells begins and ends
/// where the kernel does.
class ParcelKernel {
  public:
    ParcelKernel(const glm::vec3& place, const ParcelShape& shape, float reach) : place_(place) {
        const float own = reach * reach, all = std::max(0.5F, kLeastReach * kLeastReach - own);
        const glm::vec3 squares = own * glm::vec3(shape.xx, shape.yy, shape.zz) + all;
        const float yz = own * shape.yz, xz = own * shape.xz;
        reach_ = glm::sqrt(squares);
        zz_ = squares.z;
        y_per_z_ = yz / zz_;
        x_per_z_ = xz / zz_;
        yy_ = squares.y - yz * y_per_z_;
        x_per_y_ = (own * shape.xy - xz * y_per_z_) / yy_;
        xx_ = squares.x - xz * x_per_z_ - x_per_y_ * x_per_y_ * yy_;
    }

    /// Half of the box that holds it.
    const glm::vec3& reach() const { return reach_; }
    const glm::vec3& place() const { return place_; }

    /// A row of cells along x: K at cell i is (left - (i - middle)^2 per2)^2.
    struct Row {
        RowRange cells;
        float middle, per2, left;

        float at(int i) const {
            const float away = static_cast<float>(i) - middle, within = left - away * away * per2;
            return within * within;
        }
        /// Of all its cells, by the sums of squares and of fourth powers of n numbers around 0.
        float sum() const {
            const auto n = static_cast<float>(cells.end - cells.begin), n2 = n * n;
            const float off = 0.5F * static_cast<float>(cells.begin + cells.end - 1) - middle,
                        off2 = off * off;
            const float squares = n * (n2 - 1.0F) / 12.0F,
                        fourths = squares * (3.0F * n2 - 7.0F) / 20.0F;
            const float away2 = squares + n * off2, away4 = fourths + off2 * (6.0F * squares + n * off2);
            return n * left * left - per2 * (2.0F * left * away2 - per2 * away4);
        }
    };

    /// Calls visit(j, k, row) for the rows of cells that it reaches, 0 <= j < ny, k in `within`.
    template <class Visit>
    void for_rows(int ny, const RowRange& within, const Visit& visit) const {
        const float per_z = 1.0F / zz_, per_y = 1.0F / yy_, per_x = 1.0F / xx_;
        const RowRange layers = around(place_.z, reach_.z, within);
        std::array<float, kMostRows> left, half;
        for (int k = layers.begin; k < layers.end; ++k) {
            const float z = static_cast<float>(k) - place_.z,
                        in_layer = std::max(1.0F - z * z * per_z, 0.0F);
            const float y_middle = place_.y + y_per_z_ * z;
            const RowRange rows = around(y_middle, std::sqrt(yy_ * in_layer), {0, ny});
            const int count = std::min(rows.end - rows.begin, kMostRows);
            for (int n = 0; n < count; ++n) {
                const float y = static_cast<float>(rows.begin + n) - y_middle;
                left[n] = std::max(in_layer - y * y * per_y, 0.0F);
                half[n] = std::sqrt(xx_ * left[n]);
            }
            for (int n = 0; n < count; ++n) {
                const float y = static_cast<float>(rows.begin + n) - y_middle;
                const float middle = place_.x + x_per_z_ * z + x_per_y_ * y;
                visit(rows.begin + n, k,
                      Row{around(middle, half[n], kAnywhere), middle, per_x, left[n]});
            }
        }
    }

  private:
    static constexpr float kLeastReach = 1.5F;
    /// More than any shape that deformed() makes has at the most reach.
    static constexpr int kMostRows = 48;
    static constexpr RowRange kAnywhere = {-4096, 4096};

    /// Those between middle - half and middle + half; one that lies on an end may be among them or not,
    /// for K is 0 there.
    static RowRange around(float middle, float half, const RowRange& within) {
        return {std::max(within.begin, below(middle - half) + 1),
                std::min(within.end, below(middle + half) + 1)};
    }

    /// Without a call, which rounding down is on the oldest processors.
    static int below(float place) {
        constexpr int kFar = 4096;
        return static_cast<int>(place + static_cast<float>(kFar)) - kFar;
    }

    glm::vec3 place_, reach_;
    float xx_, yy_, zz_;  ///< of x where y and z are given, of y where z is, of z
    float x_per_y_, x_per_z_, y_per_z_;
};

}  // namespace pastoso::liquid
