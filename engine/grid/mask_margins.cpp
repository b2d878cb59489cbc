#include "grid/mask_margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pastoso::grid {
namespace {

using Distance = std::uint16_t;
constexpr Distance kFar = std::numeric_limits<Distance>::max();

/// Of every cell of an area the distance to the nearest one chosen above or below it.
class UprightDistances {
  public:
    UprightDistances(const Mask& mask, const Rect& area)
        : area_(area), distances_(static_cast<std::size_t>(area.width()) * area.height(), kFar) {
        for (int y = area.y0; y < area.y1; ++y) {
            for (int x = area.x0; x < area.x1; ++x)
                if (is_chosen(mask.at(x, y))) row(y)[x - area.x0] = 0;
            if (y > area.y0) pass_on(row(y - 1), row(y));
        }
        for (int y = area.y1 - 2; y >= area.y0; --y)
            pass_on(row(y + 1), row(y));
    }

    Distance* row(int y) { return &distances_[static_cast<std::size_t>(y - area_.y0) * area_.width()]; }

  private:
    void pass_on(const Distance* from, Distance* to) const {
        for (int x = 0; x < area_.width(); ++x)
            if (from[x] < to[x]) to[x] = static_cast<Distance>(from[x] + 1);
    }

    Rect area_;
    std::vector<Distance> distances_;
};

/// The whole numbers up to `radius`, each with the half width of a disc so far above its middle.
std::vector<int> half_widths(double radius) {
    std::vector<int> half;
    for (int above = 0; above <= radius; ++above)
        half.push_back(static_cast<int>(std::sqrt(radius * radius - 1.0 * above * above)));
    return half;
}

/// Chooses the cells of a row that a disc around a chosen cell reaches, whatever row that one is in.
void choose_reached(const Distance* upright, const std::vector<int>& half, const Rect& area,
                    std::vector<std::uint8_t>& chosen) {
    const int width = area.width();
    std::vector<int> discs(static_cast<std::size_t>(width) + 1, 0);
    for (int x = 0; x < width; ++x) {
        if (upright[x] >= half.size()) continue;
        ++discs[std::max(x - half[upright[x]], 0)];
        --discs[std::min(x + half[upright[x]] + 1, width)];
    }
    int reaching = 0;
    for (int x = 0; x < width; ++x) {
        reaching += discs[x];
        chosen[area.x0 + x] = reaching > 0 ? kWhole : 0;
    }
}

}  // namespace

Mask grown(const Mask& mask, double reach) {
    const Rect canvas = mask.shape().cells();
    const double radius = std::min(reach + 0.5, std::hypot(canvas.width(), canvas.height()));
    const int margin = static_cast<int>(radius);
    const Rect chosen_cells = chosen_area(mask);
    if (chosen_cells.empty()) return mask;
    const Rect area = intersection(canvas, {chosen_cells.x0 - margin, chosen_cells.y0 - margin,
                                            chosen_cells.x1 + margin, chosen_cells.y1 + margin});
    UprightDistances upright(mask, area);
    const std::vector<int> half = half_widths(radius);
    return mask_by_rows(mask.shape(), [&](int y, std::vector<std::uint8_t>& chosen) {
        if (y >= area.y0 && y < area.y1) choose_reached(upright.row(y), half, area, chosen);
    });
}

Mask shrunk(const Mask& mask, double reach) {
    return inverted(grown(inverted(mask), reach));
}

Mask along_outline(const Mask& mask, double reach) {
    return combined(grown(mask, reach), shrunk(mask, reach), Combination::Subtract);
}

}  // namespace pastoso::grid
