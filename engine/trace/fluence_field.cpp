#include "trace/fluence_field.hpp"

#include "core/check.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace pastoso::trace {
namespace {

/// A cell that the tea's surface may cut is looked at in so many places along each axis.
constexpr int kPlaces = 4;

/// What few photons leave is smoothed so often by (1, 2, 1) / 4 along each axis: by a cell, root mean
/// square.
constexpr int kSmoothings = 2;

float tea_share(const liquid::Cup& cup, const glm::vec3& low_m, float cell_m) {
    const float distance_m = liquid::tea_distance_m(cup, low_m + 0.5F * cell_m);
    if (distance_m > cell_m) return 0.0F;
    if (distance_m < -cell_m) return 1.0F;
    int within = 0;
    for (int k = 0; k < kPlaces; ++k)
        for (int j = 0; j < kPlaces; ++j)
            for (int i = 0; i < kPlaces; ++i) {
                const glm::vec3 place = (glm::vec3(i, j, k) + 0.5F) / static_cast<float>(kPlaces);
                if (liquid::tea_distance_m(cup, low_m + cell_m * place) < 0.0F) ++within;
            }
    return static_cast<float>(within) / static_cast<float>(kPlaces * kPlaces * kPlaces);
}

}  // namespace

FluenceField::FluenceField(const grid::BoxShape& shape, const liquid::Cup& cup, const LightSums& ways,
                           float unit)
    : shape_(shape), cells_(ways.size()) {
    PASTOSO_CHECK_OP(ways.size(), ==, static_cast<std::size_t>(shape.nx) * shape.ny * shape.nz);
    const float per_volume = unit / static_cast<float>(shape.cell_volume_m3());
    std::size_t at = 0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i, ++at)
                cells_[at] = {ways.at(at) * per_volume,
                              tea_share(cup, shape.cell_m * glm::vec3(i, j, k), shape.cell_m)};
    for (int smoothing = 0; smoothing < kSmoothings; ++smoothing) {
        smooth(shape.nx, 1);
        smooth(shape.ny, static_cast<std::size_t>(shape.nx));
        smooth(shape.nz, static_cast<std::size_t>(shape.nx) * shape.ny);
    }
}

/// Along an axis of so many cells, neighbours of which are `stride` apart. Beyond the box there is
/// nothing.
void FluenceField::smooth(int count, std::size_t stride) {
    const std::size_t cycle = stride * static_cast<std::size_t>(count);
    std::vector<Cell> row(static_cast<std::size_t>(count) + 2);
    for (std::size_t first = 0; first < cells_.size(); ++first) {
        if (first % cycle >= stride) continue;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            row[i + 1] = cells_[first + stride * i];
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            Cell& cell = cells_[first + stride * i];
            cell.ways = 0.25F * (row[i].ways + row[i + 2].ways) + 0.5F * row[i + 1].ways;
            cell.tea_share =
                0.25F * (row[i].tea_share + row[i + 2].tea_share) + 0.5F * row[i + 1].tea_share;
        }
    }
}

glm::vec3 FluenceField::at(const glm::vec3& point_m) const {
    const glm::ivec3 last = glm::ivec3(shape_.nx, shape_.ny, shape_.nz) - 1;
    const glm::vec3 place = glm::clamp(point_m / shape_.cell_m - 0.5F, glm::vec3(0.0F), glm::vec3(last));
    const glm::ivec3 low = glm::min(glm::ivec3(place), last - 1);
    const glm::vec3 share = place - glm::vec3(low);
    glm::vec3 ways(0.0F);
    float volume = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 up(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::vec3 part = glm::mix(1.0F - share, share, glm::vec3(up));
        const float weight = part.x * part.y * part.z;
        const glm::ivec3 cell = low + up;
        const Cell& there =
            cells_[static_cast<std::size_t>(cell.x + shape_.nx * (cell.y + shape_.ny * cell.z))];
        ways += weight * there.ways;
        volume += weight * there.tea_share;
    }
    return volume > 0.0F ? ways / volume : glm::vec3(0.0F);
}

}  // namespace pastoso::trace
