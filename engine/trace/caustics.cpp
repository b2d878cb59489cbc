#include "trace/caustics.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace pastoso::trace {
namespace {

/// Boxes over boxes come close to a Gaussian: two of this many cells on each side of the middle.
constexpr int kBoxReach = 2, kBoxes = 2;

/// The mean of each value of a row and its neighbours; beyond the row is nothing.
void average_row(std::vector<glm::vec3>& values, std::vector<glm::vec3>& row, std::size_t first,
                 std::size_t stride) {
    const int count = static_cast<int>(row.size());
    const auto value = [&](int i) -> glm::vec3& {
        return values[first + stride * static_cast<std::size_t>(i)];
    };
    for (int i = 0; i < count; ++i)
        row[static_cast<std::size_t>(i)] = value(i);
    for (int i = 0; i < count; ++i) {
        glm::vec3 sum(0.0F);
        for (int j = std::max(0, i - kBoxReach); j <= std::min(count - 1, i + kBoxReach); ++j)
            sum += row[static_cast<std::size_t>(j)];
        value(i) = sum / static_cast<float>(2 * kBoxReach + 1);
    }
}

}  // namespace

int TableSquare::cell(const glm::vec2& place_m) const {
    const glm::ivec2 at(glm::floor((place_m - low_m) / cell_m));
    if (at.x < 0 || at.y < 0 || at.x >= side_cells || at.y >= side_cells) return -1;
    return at.x + side_cells * at.y;
}

Caustics::Caustics(const TableSquare& square, const LightSums& arrived, float unit)
    : square_(square), irradiance_(arrived.size()) {
    PASTOSO_CHECK_OP(arrived.size(), ==,
                     static_cast<std::size_t>(square.side_cells) * square.side_cells);
    const float per_area = unit / (square.cell_m * square.cell_m);
    for (std::size_t cell = 0; cell < irradiance_.size(); ++cell)
        irradiance_[cell] = arrived.at(cell) * per_area;
    for (int box = 0; box < kBoxes; ++box)
        smooth();
}

void Caustics::smooth() {
    const auto side = static_cast<std::size_t>(square_.side_cells);
    std::vector<glm::vec3> row(side);
    for (std::size_t line = 0; line < side; ++line)
        average_row(irradiance_, row, line * side, 1);
    for (std::size_t line = 0; line < side; ++line)
        average_row(irradiance_, row, line, side);
}

glm::vec3 Caustics::irradiance(const glm::vec2& place_m) const {
    const glm::vec2 place = (place_m - square_.low_m) / square_.cell_m - 0.5F;
    const glm::ivec2 low(glm::floor(place));
    if (low.x < 0 || low.y < 0 || low.x + 1 >= square_.side_cells || low.y + 1 >= square_.side_cells)
        return glm::vec3(0.0F);
    const glm::vec2 share = place - glm::vec2(low);
    const glm::vec3* at = irradiance_.data() + low.x + square_.side_cells * low.y;
    return glm::mix(glm::mix(at[0], at[1], share.x),
                    glm::mix(at[square_.side_cells], at[square_.side_cells + 1], share.x), share.y);
}

}  // namespace pastoso::trace
