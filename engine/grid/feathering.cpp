#include "grid/feathering.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::grid {
namespace {

constexpr int kBoxes = 3;
/// To the width of a cell.
constexpr std::int64_t kSteps = 256;
/// A share in parts of a 255th, so that the roundings of all boxes together stay far below that.
using Fine = std::uint16_t;
constexpr int kFineness = 256;

/// Shares row by row.
struct Plane {
    int width, height;
    std::vector<Fine> values;
    Fine* row(int y) { return &values[static_cast<std::size_t>(y) * width]; }
};

/// Sums along a row of cells that goes on beyond its ends as it is there.
class RowSums {
  public:
    explicit RowSums(const std::vector<Fine>& row) : row_(row), sums_(row.size() + 1, 0) {
        for (std::size_t x = 0; x < row.size(); ++x)
            sums_[x + 1] = sums_[x] + row[x];
    }

    /// From the row's begin to a place, both in steps.
    std::int64_t to(std::int64_t place) const {
        const auto end = static_cast<std::int64_t>(row_.size()) * kSteps;
        if (place <= 0) return place * row_.front();
        if (place >= end) return sums_.back() * kSteps + (place - end) * row_.back();
        const auto cell = static_cast<std::size_t>(place / kSteps);
        return sums_[cell] * kSteps + place % kSteps * row_[cell];
    }

  private:
    const std::vector<Fine>& row_;
    std::vector<std::int64_t> sums_;
};

/// The means over boxes around the cells of a row, `half` steps to either side.
std::vector<Fine> box_means(const std::vector<Fine>& row, std::int64_t half) {
    const RowSums sums(row);
    std::vector<Fine> means(row.size());
    for (std::size_t x = 0; x < row.size(); ++x) {
        const std::int64_t middle = static_cast<std::int64_t>(x) * kSteps + kSteps / 2;
        const std::int64_t sum = sums.to(middle + half) - sums.to(middle - half);
        means[x] = static_cast<Fine>((sum + half) / (2 * half));
    }
    return means;
}

/// All boxes along the rows, which become columns.
Plane blurred_and_turned(Plane plane, std::int64_t half) {
    Plane turned{plane.height, plane.width, std::vector<Fine>(plane.values.size())};
    for (int y = 0; y < plane.height; ++y) {
        std::vector<Fine> row(plane.row(y), plane.row(y) + plane.width);
        for (int box = 0; box < kBoxes; ++box)
            row = box_means(row, half);
        for (int x = 0; x < plane.width; ++x)
            turned.row(x)[y] = row[x];
    }
    return turned;
}

Plane fine_shares(const Mask& mask, const Rect& area) {
    Plane plane{area.width(), area.height(), {}};
    plane.values.reserve(static_cast<std::size_t>(area.width()) * area.height());
    for (int y = area.y0; y < area.y1; ++y)
        for (int x = area.x0; x < area.x1; ++x)
            plane.values.push_back(static_cast<Fine>(mask.at(x, y) * kFineness));
    return plane;
}

}  // namespace

Mask feathered(const Mask& mask, double reach) {
    const Rect canvas = mask.shape().cells(), chosen = chosen_area(mask);
    if (chosen.empty()) return mask;
    const double near = std::min(reach, std::hypot(canvas.width(), canvas.height()));
    const int margin = static_cast<int>(near) + 1 + kBoxes;
    const Rect area = intersection(
        canvas, {chosen.x0 - margin, chosen.y0 - margin, chosen.x1 + margin, chosen.y1 + margin});
    const std::int64_t half = std::max<std::int64_t>(1, std::llround(near / kBoxes * kSteps));
    Plane plane = blurred_and_turned(blurred_and_turned(fine_shares(mask, area), half), half);
    return mask_by_rows(mask.shape(), [&](int y, std::vector<std::uint8_t>& shares) {
        if (y < area.y0 || y >= area.y1) return;
        const Fine* row = plane.row(y - area.y0);
        for (int x = area.x0; x < area.x1; ++x)
            shares[x] = static_cast<std::uint8_t>((row[x - area.x0] + kFineness / 2) / kFineness);
    });
}

}  // namespace pastoso::grid
