#include "tank/domain.hpp"

#include "liquid/flow/sampling.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::tank {
namespace {

using liquid::kAxes;
using liquid::Location;

/// Faces as deep within a solid as this matter to liquid beside it.
constexpr float kShutDepth_cells = 3.0F;

}  // namespace

Domain::Domain(const grid::BoxShape& shape, const liquid::SignedDistance& solid_m)
    : walls_(shape, [&](const glm::vec3& point_m) { return -solid_m(point_m); }),
      share_(shape),
      distance_m_(shape) {
    constexpr int kGhosts = grid::kBoxGhosts;
    for (int k = -kGhosts; k < shape.nz + kGhosts; ++k)
        for (int j = -kGhosts; j < shape.ny + kGhosts; ++j)
            for (int i = -kGhosts; i < shape.nx + kGhosts; ++i)
                distance_m_.at(i, j, k) =
                    solid_m((glm::vec3(i, j, k) + liquid::offset_cells(Location::Cell)) * shape.cell_m);
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const float share =
                    std::clamp(0.5F + distance_m_.at(i, j, k) / shape.cell_m, 0.0F, 1.0F);
                share_.at(i, j, k) = walls_.open_cells().at(i, j, k) > 0.0F ? share : 0.0F;
                has_solids_ = has_solids_ || share < 1.0F;
            }
    if (has_solids_) compute_shut_faces();
}

void Domain::compute_shut_faces() {
    const grid::BoxShape& box = shape();
    for (const int axis : kAxes) {
        const Location location = liquid::face_across(axis);
        const glm::ivec3 first(axis == 0, axis == 1, axis == 2);
        for (int k = first.z; k < box.nz; ++k)
            for (int j = first.y; j < box.ny; ++j)
                for (int i = first.x; i < box.nx; ++i) {
                    if (walls_.open().along(axis).at(i, j, k) >= kTrustedShare) continue;
                    const glm::vec3 at_m =
                        (glm::vec3(i, j, k) + liquid::offset_cells(location)) * box.cell_m;
                    if (free_m(at_m) < -kShutDepth_cells * box.cell_m) continue;
                    shut_faces_[static_cast<std::size_t>(axis)].push_back({i, j, k, normal_at(at_m)});
                }
    }
}

float Domain::free_m(const glm::vec3& point_m) const {
    return liquid::sample(distance_m_, Location::Cell, point_m, liquid::Interpolation::Linear);
}

glm::vec3 Domain::normal_at(const glm::vec3& point_m) const {
    const float step_m = 0.5F * shape().cell_m;
    glm::vec3 slope;
    for (const int axis : kAxes) {
        glm::vec3 aside(0.0F);
        aside[axis] = step_m;
        slope[axis] =
            liquid::sample(distance_m_, Location::Cell, point_m + aside, liquid::Interpolation::Linear) -
            liquid::sample(distance_m_, Location::Cell, point_m - aside, liquid::Interpolation::Linear);
    }
    const float length = glm::length(slope);
    return length > 0.0F ? slope / length : glm::vec3(0.0F);
}

glm::vec3 Domain::brought_within(glm::vec3 point_m, float margin_m) const {
    constexpr int kPushes = 3;  // as many solids may meet in a corner
    const grid::BoxShape& box = shape();
    const glm::vec3 high_m = glm::vec3(box.nx, box.ny, box.nz) * box.cell_m - margin_m;
    point_m = glm::clamp(point_m, glm::vec3(margin_m), high_m);
    if (!has_solids_) return point_m;
    for (int push = 0; push < kPushes; ++push) {
        const float distance_m = free_m(point_m);
        if (distance_m >= margin_m) break;
        point_m += normal_at(point_m) * (margin_m - distance_m);
        point_m = glm::clamp(point_m, glm::vec3(margin_m), high_m);
    }
    return point_m;
}

glm::vec3 Domain::mirrored_out(glm::vec3 point_m) const {
    const grid::BoxShape& box = shape();
    const glm::vec3 high_m = glm::vec3(box.nx, box.ny, box.nz) * box.cell_m;
    point_m = high_m - glm::abs(high_m - glm::abs(point_m));
    if (!has_solids_) return point_m;
    const float distance_m = free_m(point_m);
    if (distance_m >= 0.0F) return point_m;
    return glm::clamp(point_m - 2.0F * distance_m * normal_at(point_m), glm::vec3(0.0F), high_m);
}

void Domain::stop_at_walls(const liquid::RowRanges& samples, liquid::VelocityField& velocity,
                           core::ThreadPool& pool) const {
    const grid::BoxShape& box = shape();
    liquid::for_slices(pool, 0, box.nz + 1, [&](int k) {
        for (int j = 0; j <= box.ny; ++j) {
            const liquid::RowRange row = samples.at(j, k);
            if (row.empty()) continue;
            velocity.x.at(0, j, k) = velocity.x.at(box.nx, j, k) = 0.0F;
            if (j == 0 || j == box.ny)
                std::fill(velocity.y.row(j, k) + row.begin, velocity.y.row(j, k) + row.end, 0.0F);
            if (k == 0 || k == box.nz)
                std::fill(velocity.z.row(j, k) + row.begin, velocity.z.row(j, k) + row.end, 0.0F);
        }
    });
    if (!has_solids_) return;
    std::array<std::vector<float>, 3> slipping;
    for (const int axis : kAxes) {
        const auto& faces = shut_faces_[static_cast<std::size_t>(axis)];
        slipping[static_cast<std::size_t>(axis)].resize(faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const ShutFace& face = faces[f];
            const glm::vec3 at_m =
                (glm::vec3(face.i, face.j, face.k) + liquid::offset_cells(liquid::face_across(axis))) *
                box.cell_m;
            const glm::vec3 here = liquid::velocity_at(velocity, at_m, liquid::Interpolation::Linear);
            const float inwards = std::min(glm::dot(here, face.normal), 0.0F);
            slipping[static_cast<std::size_t>(axis)][f] = here[axis] - inwards * face.normal[axis];
        }
    }
    for (const int axis : kAxes) {
        const auto& faces = shut_faces_[static_cast<std::size_t>(axis)];
        for (std::size_t f = 0; f < faces.size(); ++f)
            velocity.along(axis).at(faces[f].i, faces[f].j, faces[f].k) =
                slipping[static_cast<std::size_t>(axis)][f];
    }
}

}  // namespace pastoso::tank
